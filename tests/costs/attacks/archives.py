# SPDX-License-Identifier: Apache-2.0
"""Archives that read archives, and procedurals."""
from attacks.attack import attack, counted, filled, scene

READ = 'ReadArchive "{}.rib"\n'


def names(count):
    return [f"a{i}" for i in range(count)]


def chained(count, times):
    """Archives that each read the next one so many times; the last holds a sphere."""
    files = {name + "_dot_rib": READ.format(after) * times
             for name, after in zip(names(count), names(count + 1)[1:])}
    files[f"a{count}_dot_rib"] = "Sphere 1 -1 1 360\n"
    return files


@attack(quick=True)
def archive_of_itself(size, chance):
    return scene(READ.format("self"), self_dot_rib=filled(size, READ.format("self")))


@attack
def archives_of_each_other(size, chance):
    each = READ.format("one") + READ.format("two")
    return scene(each, one_dot_rib=filled(size // 2, each), two_dot_rib=filled(size // 2, each))


@attack
def archive_chain(size, chance):
    return scene(READ.format("a0"), **chained(size // 100, 1))


@attack(quick=True)
def archives_twice(size, chance):
    """2^40 spheres, unless something says stop."""
    return scene(READ.format("a0"), **chained(40, 2))


@attack
def archives_three_times_long(size, chance):
    """Archives of a kilobyte of comments, each read three times."""
    files = {name: text + "#" + "x" * (size // 60) + "\n" for name, text in chained(40, 3).items()}
    return scene(READ.format("a0"), **files)


@attack
def large_archive_often(size, chance):
    """Half of the size is an archive; the other half reads it."""
    archive = filled(size // 2, "AttributeBegin AttributeEnd ")
    return scene(filled(size // 2, READ.format("a")), a_dot_rib=archive)


@attack
def large_archive_of_errors_often(size, chance):
    archive = counted(size // 2, "Nosuch{} 1 2\n")
    return scene(filled(size // 2, READ.format("a")), a_dot_rib=archive)


@attack
def archive_of_spheres_often(size, chance):
    archive = filled(size // 2, "Sphere 1 -1 1 9\n")
    return scene(filled(size // 2, READ.format("a")), a_dot_rib=archive)


@attack(quick=True)
def inline_archives_twice(size, chance):
    text = 'ArchiveBegin "a40" Sphere 1 -1 1 360 ArchiveEnd\n'
    for i in reversed(range(40)):
        text += f'ArchiveBegin "a{i}" ReadArchive "a{i + 1}" ReadArchive "a{i + 1}" ArchiveEnd\n'
    return scene(text + 'ReadArchive "a0"')


@attack
def inline_archive_often(size, chance):
    """Fifty kilobytes of calls, made again some thousand times."""
    text = 'ArchiveBegin "a" ' + filled(size // 2, "Sides 1 ") + "ArchiveEnd\n"
    return scene(text + filled(size // 2, 'ReadArchive "a"\n'))


@attack
def inline_archive_of_an_array(size, chance):
    points = filled(size // 2, "0 1 2 ")
    text = f'ArchiveBegin "a" Points "P" [{points}] "constantwidth" [.01] ArchiveEnd\n'
    return scene(text + "Translate 0 0 9 " + filled(size // 2, 'ReadArchive "a"\n'))


@attack
def procedural_of_itself(size, chance):
    request = 'Procedural "DelayedReadArchive" ["p.rib"] [-1 1 -1 1 -1 1]\n'
    return scene(request, p_dot_rib=filled(size, request))


@attack
def procedurals_refused(size, chance):
    return scene(counted(size, 'Procedural "RunProgram" ["cat {}" "x"] [-1 1 -1 1 -1 1]\n'))


@attack
def condition_each_archive(size, chance):
    """Archives that end by their conditions alone."""
    text = ('IfBegin "$user:n != \'x\'" ReadArchive "c.rib" ReadArchive "c.rib" IfEnd\n')
    return scene(READ.format("c"), c_dot_rib=text)


@attack
def archives_missing(size, chance):
    return scene(counted(size, 'ReadArchive "nosuch{}.rib"\n'))
