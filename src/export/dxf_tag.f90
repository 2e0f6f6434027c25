!> A DXF file under way: group codes and values, two lines each, and the handles that R2000 gives
!> to everything.
!>
!>       0           group code, in three columns
!>     LINE          value
!>      10
!>     12.5
!>
!> Source: Autodesk, "DXF Reference" for release 12 and for AutoCAD 2000, group code value types.
module export_dxf_tag
    use base_digits, only: shortest
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: right, to_text, upper
    implicit none (type, external)
    private

    public :: dxf_type, model_space, paper_space, model_layout, paper_layout, plot_style

    !> Handles of the two blocks, of which the first has all entities, of their layouts and of the
    !> one plot style; the first that anything else may have.
    character(*), parameter :: model_space = '1F', paper_space = '1B', model_layout = '22', &
        paper_layout = '1E', plot_style = 'F'
    integer, parameter :: first_free = 256

    !> A file under way.
    type :: dxf_type
        logical :: has_handles = .false.    !! R2000, else R12
        integer :: handle = first_free      !! next to be given
        type(output_type) :: out            !! what is written, in memory
    contains
        procedure, private :: put_text, put_whole, put_real
        generic :: tag => put_text, put_whole, put_real
        procedure :: point => put_point
        procedure :: vector => put_vector
        procedure :: section
        procedure :: new => begin_entity
        procedure :: class => put_class
        procedure :: next_handle
    end type dxf_type

contains

    !> Puts a text. It must be free of line ends.
    subroutine put_text(file, code, value)
        class(dxf_type), intent(inout) :: file  !! the file
        integer, intent(in) :: code             !! group code
        character(*), intent(in) :: value       !! as it shall stand there
        call file%out%line(right(to_text(code), 3))
        call file%out%line(value)
    end subroutine put_text

    !> Puts a whole number.
    subroutine put_whole(file, code, value)
        class(dxf_type), intent(inout) :: file  !! the file
        integer, intent(in) :: code             !! group code
        integer, intent(in) :: value            !! any
        call file%tag(code, right(to_text(value), 6))
    end subroutine put_whole

    !> Puts a real number in figures that read back as the same.
    subroutine put_real(file, code, value)
        class(dxf_type), intent(inout) :: file  !! the file
        integer, intent(in) :: code             !! group code
        real(dp), intent(in) :: value           !! finite
        call file%tag(code, pointed(shortest(value)))
    end subroutine put_real

    !> A number with a point before its power of ten, without which some readers take it for a whole
    !> one.
    pure function pointed(figures) result(text)
        character(*), intent(in) :: figures !! a number
        character(:), allocatable :: text
        integer :: power
        text = upper(figures)
        if (index(text, '.') > 0) return
        power = scan(text//'E', 'E')
        text = text(:power - 1)//'.0'//text(power:)
    end function pointed

    !> Puts a point of a plane, at height zero, or of space.
    subroutine put_point(file, code, at)
        class(dxf_type), intent(inout) :: file  !! the file
        integer, intent(in) :: code             !! group code of x
        real(dp), intent(in) :: at(:)           !! shape (2) or (3)
        call file%vector(code, at)
        if (size(at) == 2) call file%tag(code + 20, 0.0_dp)
    end subroutine put_point

    !> Puts the coordinates that there are.
    subroutine put_vector(file, code, at)
        class(dxf_type), intent(inout) :: file  !! the file
        integer, intent(in) :: code             !! group code of x
        real(dp), intent(in) :: at(:)           !! shape (2) or (3)
        integer :: i
        do i = 1, size(at)
            call file%tag(code + 10*(i - 1), at(i))
        end do
    end subroutine put_vector

    !> Begins a section, or ends one where it has no name.
    subroutine section(file, name)
        class(dxf_type), intent(inout) :: file  !! the file
        character(*), intent(in) :: name        !! HEADER, TABLES...
        if (name == '') then
            call file%tag(0, 'ENDSEC')
        else
            call file%tag(0, 'SECTION')
            call file%tag(2, name)
        end if
    end subroutine section

    !> Begins an entity of the drawing.
    subroutine begin_entity(file, kind, layer)
        class(dxf_type), intent(inout) :: file  !! the file
        character(*), intent(in) :: kind        !! LINE, TEXT...
        character(*), intent(in) :: layer       !! name of its layer
        call file%tag(0, kind)
        if (file%has_handles) then
            call file%tag(5, file%next_handle())
            call file%tag(330, model_space)
        end if
        call file%class('AcDbEntity')
        call file%tag(8, layer)
    end subroutine begin_entity

    !> Says of which class the groups are that follow, which R12 does not know.
    subroutine put_class(file, name)
        class(dxf_type), intent(inout) :: file  !! the file
        character(*), intent(in) :: name        !! AcDbLine...
        if (file%has_handles) call file%tag(100, name)
    end subroutine put_class

    !> A handle that nothing has yet: a number in hexadecimal figures.
    function next_handle(file) result(handle)
        class(dxf_type), intent(inout) :: file  !! the file
        character(:), allocatable :: handle
        character(8) :: field
        write (field, '(z0)') file%handle
        handle = trim(field)
        file%handle = file%handle + 1
    end function next_handle

end module export_dxf_tag
