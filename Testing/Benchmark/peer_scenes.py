"""Writes the table of VTK's scenes: peer_scenes.py RENDER_TESTS OUTPUT.md

RENDER_TESTS is the program FlatBlockRenderTests. Its scenes are those of VTK's own tests of
vtkGPUVolumeRayCastMapper, which draws them, too, in the same process.
"""

import sys

import records


def write(rows, output):
    covered = [row[1:] for row in rows if row[0] == "covered"]
    left_out = [row[1:] for row in rows if row[0] == "left out"]
    ratios = sorted(float(row[3]) / float(row[4]) for row in covered)
    with open(output, "w", encoding="utf-8") as page:
        records.write_head(
            page, "The scenes of VTK's tests", "peer_scenes.py", "docs/peer-scenes.md"
        )
        page.write(
            "Each row is a test of vtkGPUVolumeRayCastMapper (TestGPURayCast...), drawn by both\n"
            "mappers in one process: 256 x 256 pixels, 48 x 44 x 52 generated samples, the same\n"
            "steps. PSNR in dB and structural similarity (1: the same) of the two pictures;\n"
            "milliseconds of a still frame, medians of 5. All %d pass. Half of the frames take\n"
            "less than %.2f of VTK's time, all less than %.2f.\n\n"
            % (len(covered), ratios[len(ratios) // 2], ratios[-1])
        )
        page.write("| scene | PSNR | similarity | ours | VTK's | ratio | |\n|---|---|---|---|---|---|---|\n")
        for name, psnr, ssim, ours, theirs, remark in covered:
            ratio = float(ours) / float(theirs)
            page.write(
                "| %s | %.1f | %.3f | %.1f | %.1f | %.2f | %s |\n"
                % (name, float(psnr), float(ssim), float(ours), float(theirs), ratio, remark)
            )
        page.write("\n## Left out\n\n| scene | why |\n|---|---|\n")
        for names, reason in left_out:
            page.write("| %s | %s |\n" % (names.replace("*", "\\*"), reason))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    write(records.run(sys.argv[1], "*PeerScenes*", "FLATBLOCK_PEER_SCENES"), sys.argv[2])
