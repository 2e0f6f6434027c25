!> What the system says of a file: whether there is one, of what kind, with what permissions. Names
!> are taken to their last byte, blanks too.
!>
!> POSIX has this in a structure that each system lays out for itself; the Fortran runtime turns it
!> into thirteen numbers that are alike on all. It takes them as the descriptor of an array, whose
!> form the manual of GNU Fortran gives ("Array descriptor", 8 and later).
module base_file_facts
    use, intrinsic :: iso_c_binding, only: c_char, c_int, c_intptr_t, c_loc, c_ptr, c_short, &
        c_signed_char, c_size_t
    use base_posix, only: c_text
    implicit none (type, external)
    private

    public :: file_facts_type, facts_of_file

    !> What is known of a file. Of a link it is what the link leads to.
    type :: file_facts_type
        logical :: exists = .false.         !! there is something of that name
        logical :: is_regular = .false.     !! a file with bytes in it: no device, FIFO or folder
        logical :: is_folder = .false.      !! a folder
        integer(c_int) :: permissions = 0   !! of owner, group and others, as octal 777
        integer(c_int) :: length = 0        !! bytes; of 2 GiB or more some other number above 0
    end type file_facts_type

    !> Numbers the runtime gives; where among them stand mode and length.
    integer, parameter :: numbers = 13, mode_place = 3, length_place = 8
    !> Parts of the mode: the kind of file, two of its kinds, the permissions (POSIX, `cpio.h`).
    integer(c_int), parameter :: kind_mask = int(o'170000', c_int)
    integer(c_int), parameter :: regular = int(o'100000', c_int), folder = int(o'040000', c_int)
    integer(c_int), parameter :: permission_mask = int(o'777', c_int)

    !> An array of one dimension as GNU Fortran hands it over.
    type, bind(c) :: array_type
        type(c_ptr) :: start                    !! its first element
        integer(c_size_t) :: offset = 0         !! from element 0, in elements; wraps around
        integer(c_size_t) :: element = 4        !! bytes
        integer(c_int) :: version = 0
        integer(c_signed_char) :: rank = 1
        integer(c_signed_char) :: kind = 1      !! integers
        integer(c_short) :: attribute = 0
        integer(c_intptr_t) :: span = 4         !! bytes from one element to the next
        integer(c_intptr_t) :: stride = 1       !! elements
        integer(c_intptr_t) :: lower = 1
        integer(c_intptr_t) :: upper = numbers
    end type array_type

    interface
        !> The numbers of a file; status 0 where there is one.
        subroutine stat_of(path, array, status, length) bind(c, name='_gfortran_stat_i4_sub')
            import :: array_type, c_char, c_int, c_size_t
            character(kind=c_char), intent(in) :: path(*)   !! ends with a null
            type(array_type), intent(inout) :: array        !! where the numbers go
            integer(c_int), intent(out) :: status           !! 0, or the number of the error
            integer(c_size_t), value :: length              !! of the path, its null too
        end subroutine stat_of
    end interface

contains

    !> What the system says of a file.
    function facts_of_file(path) result(facts)
        character(*), intent(in) :: path !! any path
        type(file_facts_type) :: facts
        integer(c_int), target :: number(numbers)
        type(array_type) :: array
        integer(c_int) :: status, mode

        number = 0
        array%start = c_loc(number)
        array%offset = not(0_c_size_t)
        call stat_of(c_text(path), array, status, len(path, c_size_t) + 1_c_size_t)
        if (status /= 0) return
        mode = number(mode_place)
        facts%exists = .true.
        facts%is_regular = iand(mode, kind_mask) == regular
        facts%is_folder = iand(mode, kind_mask) == folder
        facts%permissions = iand(mode, permission_mask)
        facts%length = number(length_place)
        if (facts%length < 0) facts%length = huge(facts%length)
    end function facts_of_file

end module base_file_facts
