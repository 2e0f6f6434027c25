!> The entities of an IGES file: the directory, two cards for each, and their parameters
!> (IGES 5.3, 2.2.4.4 and 2.2.4.5).
!>
!>          1-8     9-16    17-24    25-32    33-40    41-48    49-56    57-64    65-72 73-80
!>     type     first P  (none)   font     level    (none)   matrix   (none)   status    D
!>     type     weight   colour   P cards  form     (none)   (none)   label    number    D
module export_iges_file
    use base_text, only: right, row_of, to_text
    use export_iges_card, only: section_type
    use export_iges_record, only: record_type
    implicit none (type, external)
    private

    public :: entry_type, iges_file_type

    !> The status of an entity: whether it is seen, depends on others, what it is for, and whether
    !> its attributes are those of what depends on it.
    type, public :: status_list
        character(8) :: geometry = '00000000'   !! stands for itself
        character(8) :: part = '00010000'       !! of another entity
        character(8) :: parametric = '00010500' !! a curve over u and v of a surface
        character(8) :: name = '00010200'       !! a definition, of another entity
        character(8) :: definition = '00000200' !! a definition
    end type status_list

    !> The statuses by name.
    type(status_list), parameter, public :: iges_status = status_list()

    !> What the directory says of an entity.
    type :: entry_type
        integer :: form = 0             !! of the type of entity
        integer :: level = 0            !! 0: none
        integer :: colour = 0           !! 1 black to 8 white; 0: none
        integer :: matrix = 0           !! pointer to its transformation; 0: none
        integer :: number = 0           !! behind the label; 0: none
        character(8) :: label = ''      !! for a reader's list
        character(8) :: status = iges_status%geometry !! one of `iges_status%...`
        logical :: is_line = .false.    !! it is drawn, with a full line
    end type entry_type

    !> The entities, as far as they are written.
    type :: iges_file_type
        type(section_type) :: directory = section_type('D')     !! section D
        type(section_type) :: parameters = section_type('P')    !! section P
    contains
        procedure :: add
    end type iges_file_type

contains

    !> Adds an entity.
    subroutine add(file, kind, entry, record, pointer)
        class(iges_file_type), intent(inout) :: file    !! the file
        integer, intent(in) :: kind                     !! type of entity, first of the record
        type(entry_type), intent(in) :: entry           !! what the directory says
        type(record_type), intent(in) :: record         !! its parameters
        integer, intent(out) :: pointer                 !! by which others refer to it
        integer :: first

        pointer = file%directory%count + 1
        first = file%parameters%count + 1
        call file%parameters%put_free(record%content(), pointer)
        call file%directory%put_card(field(kind)//field(first)//field(0)// &
            field(merge(1, 0, entry%is_line))//field(entry%level)//field(0)// &
            field(entry%matrix)//field(0)//entry%status)
        call file%directory%put_card(field(kind)//field(0)//field(entry%colour)// &
            field(file%parameters%count - first + 1)//field(entry%form)//row_of(' ', 16)// &
            right(entry%label, 8)//field(entry%number))
    end subroutine add

    !> A whole number in its columns.
    pure function field(value) result(text)
        integer, intent(in) :: value !! any
        character(8) :: text
        text = right(to_text(value), 8)
    end function field

end module export_iges_file
