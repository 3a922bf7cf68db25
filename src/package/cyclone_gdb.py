# Cyclone's types in gdb, written as print.h writes them:   (gdb) source cyclone_gdb.py
import gdb
import gdb.printing


def number(value):
    return format(float(value), '.15g')


def vector(value):
    return '(' + ', '.join(number(value[name]) for name in 'xyz') + ')'


def quaternion(value):
    return number(value['r']) + ''.join(format(float(value[name]), '+.15g') + name for name in 'ijk')


def matrix(value, columns):
    entries = [number(value['data'][n]) for n in range(3 * columns)]
    rows = [' '.join(entries[n:n + columns]) for n in range(0, len(entries), columns)]
    return '[' + '; '.join(rows) + ']'


def body(value):
    mass = 'immovable' if float(value['inverseMass']) == 0 else number(value['mass']) + ' kg'
    position = '(' + ', '.join(number(value['transform']['data'][n]) for n in (3, 7, 11)) + ')'
    sleep = '' if value['awake'] else ', faulted' if value['faulted'] else ', asleep'
    return (f"{mass} at {position}, orientation {quaternion(value['orientation'])}, "
            f"velocity {vector(value['velocity'])}, rotation {vector(value['rotation'])}{sleep}")


def printer_of(text):
    class Printer:
        def __init__(self, value):
            self.value = value

        def to_string(self):
            return text(self.value)

    return Printer


def register():
    printers = gdb.printing.RegexpCollectionPrettyPrinter('cyclone')
    for name, text in (('Vector3', vector), ('Quaternion', quaternion),
                       ('Matrix3', lambda value: matrix(value, 3)),
                       ('Matrix4', lambda value: matrix(value, 4)), ('RigidBody', body)):
        printers.add_printer(name, f'^cyclone::{name}$', printer_of(text))
    gdb.printing.register_pretty_printer(gdb.current_objfile(), printers, replace=True)


register()
