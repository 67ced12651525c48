"""Reads the files that a run writes: particles, grids, series of them, and tables."""
import xml.etree.ElementTree as xml

from plot_libraries import np


class Missing(Exception):
    """Something that a picture needs is not there; says what in one line."""


class NotWritten(Missing):
    """What a picture needs is a column that the run was not asked to write."""


class Mistake(Exception):
    """What was asked for cannot be meant; says why in one line."""


class Arrays(dict):
    """Arrays by name, left on the disk until they are used; then in double precision, which sums over many
    particles need."""

    def __getitem__(self, name):
        values = super().__getitem__(name)
        return values.astype(float) if values.dtype == np.float32 else values


def complete(table, needed, path):
    """The table, if it has all the columns that are needed, and rows."""
    for name in needed:
        if name not in table:
            raise Missing(f"{path} has no column '{name}'")
    if len(table[needed[0]]) == 0:
        raise Missing(f"{path} is empty")
    return table


def read_vtk(path):
    """The XML head of a file of particles or of a grid, and its arrays."""
    mark = b'<AppendedData encoding="raw">\n_'
    arrays = Arrays()
    try:
        raw = np.memmap(path, dtype=np.uint8, mode="r")
        text = bytes(raw[: 1 << 16]).partition(mark)[0]
        head = xml.fromstring(text + b"</VTKFile>")
        for array in head.iter("DataArray"):
            begin = len(text) + len(mark) + int(array.get("offset")) + 8
            kind = np.dtype(array.get("type").lower()).newbyteorder("<")
            rows = int(raw[begin - 8 : begin].view("<u8")[0]) // kind.itemsize
            columns = int(array.get("NumberOfComponents"))
            values = np.frombuffer(raw, kind, rows, begin) if rows else np.empty(0, kind)
            arrays[array.get("Name")] = values.reshape(-1, columns) if columns > 1 else values
    except FileNotFoundError:
        raise Missing(f"no {path}") from None
    except (ValueError, IndexError, xml.ParseError):
        raise Missing(f"{path} is cut off or no file of particles or of a grid") from None
    return head, arrays


def read_grid(path):
    """The arrays of a grid file by name, with the centres of its cells as "Points" [m], x fastest, and
    their size "spacing" [m]."""
    head, arrays = read_vtk(path)
    box = head.find("ImageData")
    ends = [int(end) for end in box.get("WholeExtent").split()]
    origin, spacing = ([float(x) for x in box.get(name).split()] for name in ("Origin", "Spacing"))
    axes = [origin[d] + spacing[d] * (np.arange(max(ends[2 * d + 1], 1)) + 0.5 * (ends[2 * d + 1] > 0))
            for d in range(3)]
    z, y, x = np.meshgrid(*axes[::-1], indexing="ij")
    arrays["Points"] = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
    arrays["spacing"] = np.float64(spacing[0])
    return complete(arrays, ("fill",), path)


def read_series(path):
    """(time, name of the file) of each output of a series [s]."""
    try:
        sets = xml.parse(path).getroot().iter("DataSet")
        return [(float(one.get("timestep")), one.get("file")) for one in sets]
    except (FileNotFoundError, xml.ParseError):
        raise Missing(f"no {path}, or it is cut off") from None


def read_csv(path, needed):
    """The columns of a table by name; a last line that is still being written is left out."""
    try:
        with open(path) as file:
            names = [name.strip() for name in file.readline().split(",")]
            rows = [line.split(",") for line in file if line.endswith("\n")]
        rows = np.array([row for row in rows if len(row) == len(names)], dtype=float)
    except FileNotFoundError:
        raise Missing(f"no {path}") from None
    except ValueError:
        raise Missing(f"{path} holds something that is no number") from None
    return complete(dict(zip(names, rows.reshape(-1, len(names)).T)), needed, path)
