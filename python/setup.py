"""Builds the wheel and the source distribution by scikit-build; what the package is stands in pyproject.toml."""

import re
import shutil
from pathlib import Path

import skbuild
from skbuild.command.sdist import sdist

HERE = Path(__file__).resolve().parent
# In a source distribution the library's sources lie within it, in the repository beside it.
LIBRARY = HERE / "cpp" if (HERE / "cpp").exists() else HERE.parent
FOLDER_LISTS = ["src/core_folders.txt", "src/format_folders.txt"]


def version() -> str:
    found = re.search(r"project\(waybreaker VERSION ([\d.]+)", (LIBRARY / "CMakeLists.txt").read_text())
    if not found:
        raise SystemExit(f"{LIBRARY / 'CMakeLists.txt'} does not state a version")
    return found[1]


class SourceDistribution(sdist):
    """With the sources of the library, as far as the package needs them."""

    def make_release_tree(self, base_dir: str, files: "list[str]") -> None:
        super().make_release_tree(base_dir, files)
        root = Path(base_dir)
        for name in ["CMakeLists.txt", "cmake", "include", "src/CMakeLists.txt", *FOLDER_LISTS]:
            self.add(root, name)
        for listed in FOLDER_LISTS:
            for folder in (LIBRARY / listed).read_text().split():
                self.add(root, f"src/{folder}")
        self.add(root, "LICENSE")
        (root / "LICENSE").unlink(missing_ok=True)  # a link in the repository
        shutil.copy(LIBRARY / "LICENSE", root / "LICENSE")

    @staticmethod
    def add(root: Path, name: str) -> None:
        target = root / "cpp" / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if (LIBRARY / name).is_dir():
            shutil.copytree(LIBRARY / name, target)
        else:
            shutil.copy(LIBRARY / name, target)


skbuild.setup(
    version=version(),
    packages=["waybreaker"],
    package_data={"waybreaker": ["py.typed", "*.pyi"]},
    include_package_data=False,
    cmake_install_dir="waybreaker",
    cmdclass={"sdist": SourceDistribution},
    zip_safe=False,
)
