/// Every C++ arithmetic type that a VTK array can hold.
#pragma once

#define FLATBLOCK_FOR_SAMPLE_TYPES(DO)                                                             \
  DO(char)                                                                                         \
  DO(signed char)                                                                                  \
  DO(unsigned char)                                                                                \
  DO(short)                                                                                        \
  DO(unsigned short)                                                                               \
  DO(int)                                                                                          \
  DO(unsigned int)                                                                                 \
  DO(long)                                                                                         \
  DO(unsigned long)                                                                                \
  DO(long long)                                                                                    \
  DO(unsigned long long)                                                                           \
  DO(float)                                                                                        \
  DO(double)
