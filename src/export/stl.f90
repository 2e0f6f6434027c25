!> STL files, ASCII and binary: triangles with their normals and corners, no more. The format has no
!> place for units; they are in the name of the solid or in the header.
!>
!> Source: 3D Systems, "StereoLithography Interface Specification", 1989, as in M. Burns, "Automated
!> Fabrication", Prentice Hall 1993, 6.5. A binary file is a header of 80 bytes, the number of
!> triangles (32 bits), and for each 12 reals of 32 bits and 2 bytes of 0, all little-endian. Its
!> header must not begin with `solid`, by which programs know the ASCII form.
module export_stl
    use base_constants, only: version
    use base_digits, only: fixed, shortest
    use base_exact, only: is_equal
    use base_kinds, only: dp, i64
    use base_output, only: output_type
    use base_text, only: compact, counted, first_bytes, printable, row_of
    use export_mesh, only: mesh_type
    use export_mesh_receipt, only: note_mesh
    use export_mesh_strip, only: facet_normal
    use export_receipt, only: receipt_type
    implicit none (type, external)
    private

    public :: write_stl

    !> Short reals, 32 bits.
    integer, parameter :: sp = kind(1.0)
    !> Bytes of the header of a binary file, and characters of a title in it.
    integer, parameter :: header_size = 80
    !> Decimals of normals.
    integer, parameter :: decimals = 6

contains

    !> Writes a mesh. Short reals are rounded, the same number always to the same, so that a closed
    !> mesh stays closed: a triangle that has shrunk to a line by this is left out, and those beside
    !> it then meet.
    subroutine write_stl(mesh, is_binary, out, receipt)
        type(mesh_type), intent(in) :: mesh             !! in the unit of the file
        logical, intent(in) :: is_binary                !! binary, else ASCII
        type(output_type), intent(inout) :: out         !! gets the file
        type(receipt_type), intent(inout) :: receipt    !! gets what was written

        call note_mesh(mesh, 'TRIANGLES', receipt)
        if (is_binary) then
            call write_binary(mesh, out, receipt)
        else
            call write_ascii(mesh, out)
        end if
    end subroutine write_stl

    !> Writes the ASCII form.
    subroutine write_ascii(mesh, out)
        type(mesh_type), intent(in) :: mesh         !! in the unit of the file
        type(output_type), intent(inout) :: out     !! gets the file
        real(dp) :: at(3, 3)
        integer :: i, k

        call out%line('solid '//name_of(mesh)//' UNITS='//mesh%units)
        do i = 1, mesh%triangle_count
            at = mesh%vertices(:, mesh%triangles(:, i))
            call out%line('facet normal '//decimals_of(facet_normal(at)))
            call out%line('outer loop')
            do k = 1, 3
                call out%line('vertex '//shortest(at(1, k))//' '//shortest(at(2, k))//' '// &
                    shortest(at(3, k)))
            end do
            call out%line('endloop')
            call out%line('endfacet')
        end do
        call out%line('endsolid '//name_of(mesh)//' UNITS='//mesh%units)
    end subroutine write_ascii

    !> The title of the deck, or its file name.
    pure function name_of(mesh) result(name)
        type(mesh_type), intent(in) :: mesh !! any
        character(:), allocatable :: name
        name = trim(printable(mesh%title))
        if (len(name) == 0) name = trim(printable(mesh%deck))
    end function name_of

    !> A vector in decimals.
    pure function decimals_of(vector) result(text)
        real(dp), intent(in) :: vector(3) !! of unit length
        character(:), allocatable :: text
        integer, parameter :: width = decimals + 3
        text = trim(adjustl(fixed(vector(1), width, decimals)))//' '// &
            trim(adjustl(fixed(vector(2), width, decimals)))//' '// &
            trim(adjustl(fixed(vector(3), width, decimals)))
    end function decimals_of

    !> Writes the binary form.
    subroutine write_binary(mesh, out, receipt)
        type(mesh_type), intent(in) :: mesh             !! in the unit of the file
        type(output_type), intent(inout) :: out         !! gets the file
        type(receipt_type), intent(inout) :: receipt    !! is told what rounding did
        character(:), allocatable :: header
        real(sp) :: at(3, 3)
        real(dp) :: rounding
        integer :: i, kept

        header = 'LOFT '//version//' BINARY STL UNITS='//mesh%units//' '//name_of(mesh)
        header = header(:first_bytes_within(header, header_size))
        call out%put(header//row_of(' ', header_size - len(header)))
        kept = 0
        rounding = 0.0_dp
        do i = 1, mesh%triangle_count
            at = short(mesh%vertices(:, mesh%triangles(:, i)))
            rounding = max(rounding, maxval(norm2(real(at, dp) &
                - mesh%vertices(:, mesh%triangles(:, i)), dim=1)))
            if (.not. is_line(at)) kept = kept + 1
        end do
        call out%put(bytes_of(kept))
        do i = 1, mesh%triangle_count
            at = short(mesh%vertices(:, mesh%triangles(:, i)))
            if (is_line(at)) cycle
            call out%put(reals(short(facet_normal(mesh%vertices(:, mesh%triangles(:, i)))))// &
                reals(at(:, 1))//reals(at(:, 2))//reals(at(:, 3))//char(0)//char(0))
        end do
        call receipt%say('binary STL has reals of 32 bits: vertices are moved by up to '// &
            compact(rounding)//', and '// &
            counted(int(mesh%triangle_count - kept, i64), 'triangle')// &
            ' of no area then left out')
    end subroutine write_binary

    !> As many bytes of a text as there is room for, without part of a character.
    pure integer function first_bytes_within(text, room) result(bytes)
        character(*), intent(in) :: text    !! any text
        integer, intent(in) :: room         !! bytes
        integer :: count
        count = room
        bytes = first_bytes(text, count)
        do while (bytes > room)
            count = count - 1
            bytes = first_bytes(text, count)
        end do
    end function first_bytes_within

    !> A number as a short real; the largest where it is larger.
    elemental real(sp) function short(value)
        real(dp), intent(in) :: value !! a finite number
        real(dp), parameter :: most = real(huge(1.0_sp), dp)
        short = real(max(-most, min(most, value)), sp)
    end function short

    !> True for a triangle of which two corners are one.
    pure logical function is_line(at)
        real(sp), intent(in) :: at(3, 3) !! its corners by columns
        integer :: i
        is_line = any([(all(is_equal(real(at(:, i), dp), &
            real(at(:, mod(i, 3) + 1), dp))), i=1, 3)])
    end function is_line

    !> The bytes of short reals.
    pure function reals(values) result(bytes)
        real(sp), intent(in) :: values(3) !! any; a zero of either sign is the one above
        character(12) :: bytes
        integer :: i
        do i = 1, 3
            bytes(4*i - 3:4*i) = bytes_of(transfer(values(i) + 0.0_sp, 1))
        end do
    end function reals

    !> The bytes of a whole number of 32 bits, the least first.
    pure function bytes_of(value) result(bytes)
        integer, intent(in) :: value !! any
        character(4) :: bytes
        integer :: i
        do i = 1, 4
            bytes(i:i) = char(ibits(value, 8*(i - 1), 8))
        end do
    end function bytes_of

end module export_stl
