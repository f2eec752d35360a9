// How many times textures are read along the ray: the atlas, its index, the map of leaps, the table.

#ifdef FLATBLOCK_COUNTING
int fetches = 0;
#endif

void countFetches(int number)
{
#ifdef FLATBLOCK_COUNTING
  fetches += number;
#endif
}
