# SPDX-License-Identifier: LGPL-2.1-or-later
"""A film of pictures of one size: mp4 through ffmpeg where it is installed, else gif."""
import os
import shutil
import subprocess
import tempfile

from PIL import Image

SECOND = 8  # pictures a second


def make(paths, path_without_end):
    """Returns the path of the film."""
    if shutil.which("ffmpeg"):
        return with_ffmpeg(paths, path_without_end + ".mp4")
    return as_gif(paths, path_without_end + ".gif")


def with_ffmpeg(paths, path):
    with tempfile.TemporaryDirectory() as folder:
        for number, picture in enumerate(paths):
            os.symlink(os.path.abspath(picture), os.path.join(folder, f"{number:05d}.png"))
        # yuv420p, which all players have, wants even numbers of pixels
        subprocess.run(["ffmpeg", "-y", "-loglevel", "error", "-framerate", str(SECOND), "-i", os.path.join(folder, "%05d.png"), "-vf",
                        "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-c:v", "libx264", "-pix_fmt", "yuv420p", path], check=True)
    return path


def as_gif(paths, path):
    """With one palette for all pictures, from some of them, so that colours do not flicker."""
    some = [Image.open(picture).convert("RGB") for picture in paths[::max(len(paths) // 4, 1)]]
    sheet = Image.new("RGB", (some[0].width, sum(image.height for image in some)))
    for number, image in enumerate(some):
        sheet.paste(image, (0, number * some[0].height))
    palette = sheet.quantize(256)
    first, *others = [Image.open(picture).convert("RGB").quantize(palette=palette, dither=Image.Dither.NONE) for picture in paths]
    first.save(path, save_all=True, append_images=others, duration=[*[1000 // SECOND] * len(others), 2000], loop=0)
    return path
