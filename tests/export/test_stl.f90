!> Tests of STL files: the ASCII form as text, the binary form byte by byte.
program test_stl
    use base_kinds, only: dp
    use base_output, only: output_type
    use export_mesh, only: mesh_type
    use export_receipt, only: receipt_type
    use export_stl, only: write_stl
    use support_tap, only: tap_type
    use support_tetrahedron, only: tetrahedron
    implicit none (type, external)

    type(tap_type) :: tap
    type(mesh_type) :: mesh
    type(output_type) :: out, binary, other
    type(receipt_type) :: receipt, rounded, left_out
    character(:), allocatable :: bytes
    character(*), parameter :: feed = new_line('a')

    mesh = tetrahedron()
    call write_stl(mesh, .false., out, receipt)
    call tap%ok(index(out%text(), 'solid FOUR FACES UNITS=INCHES'//feed) == 1, &
        'the name of the solid has title and units')
    call tap%has(out%text(), feed//'facet normal 0.000000 -1.000000 0.000000'//feed// &
        'outer loop'//feed//'vertex 0 0 0'//feed//'vertex 1 0 0'//feed//'vertex 0 0 0.1'//feed// &
        'endloop'//feed//'endfacet'//feed, 'a facet, its normal and corners in shortest figures')
    call tap%has(out%text(), 'endfacet'//feed//'endsolid FOUR FACES UNITS=INCHES'//feed, &
        'the end has the name too')
    call tap%ok(count_of(out%text(), 'facet normal') == 4, 'all facets are there')
    call tap%ok(receipt%count == 2, 'the receipt has the parts')

    call write_stl(mesh, .true., binary, rounded)
    bytes = binary%text()
    call tap%ok(len(bytes) == 84 + 4*50, 'a binary file is 84 bytes and 50 a triangle')
    call tap%ok(index(bytes, 'LOFT ') == 1 .and. &
        index(bytes(:80), 'UNITS=INCHES FOUR FACES ') > 0, &
        'its header has units and title and does not begin with solid')
    call tap%same(hex(bytes(81:84)), '04000000', 'then the count, the least byte first')
    ! -1 is bf800000, 2 is 40000000, .1 is 3dcccccd.
    call tap%same(hex(bytes(85:96)), '00000000'//'00000000'//'000080BF', 'a normal')
    call tap%same(hex(bytes(109:120)), '00000000'//'00000040'//'00000000', 'a corner')
    call tap%same(hex(bytes(85 + 50 + 36:85 + 50 + 47)), '00000000'//'00000000'//'CDCCCC3D', &
        'a short real is rounded')
    call tap%same(hex(bytes(133:134)), '0000', 'each triangle ends with two bytes of 0')
    call tap%has(rounded%notes, 'moved by up to 1.49012E-09, and 0 triangles', &
        'the receipt says how far rounding moves vertices')

    mesh%vertices(:, 2) = [1.0e-9_dp, 2.0_dp, 0.0_dp]
    mesh%vertices(1, 3) = 0.5e-46_dp
    mesh%vertices(:, 2) = mesh%vertices(:, 3)*(1.0_dp + 1.0e-12_dp)
    call write_stl(mesh, .true., other, left_out)
    bytes = other%text()
    call tap%same(hex(bytes(81:84)), '02000000', 'triangles that rounding makes lines are left out')
    call tap%ok(len(bytes) == 84 + 2*50, 'and counted so')
    call tap%has(left_out%notes, '2 triangles of no area', 'the receipt says it')
    mesh%title = ''
    mesh%vertices(1, 2) = -1.0e300_dp
    call empty(other)
    call write_stl(mesh, .true., other, left_out)
    bytes = other%text()
    call tap%has(bytes(:80), 'a b.crd', 'without a title the deck is named')
    call tap%ok(index(hex(bytes(85:)), 'FFFF7FFF') > 0, 'what is too large is the largest')
    mesh%title = 'ELEVEN BYTES AND MORE, WITH SUCH A LONG TITLE THAT IT DOES NOT FIT INTO IT AT ALL'
    call empty(other)
    call write_stl(mesh, .true., other, left_out)
    bytes = other%text()
    call tap%same(hex(bytes(81:84)), '04000000', 'a long title is cut at 80 bytes')
    call tap%finish()

contains

    !> Bytes as hexadecimal figures.
    function hex(text)
        character(*), intent(in) :: text
        character(2*len(text)) :: hex
        integer :: i
        do i = 1, len(text)
            write (hex(2*i - 1:2*i), '(z2.2)') ichar(text(i:i))
        end do
    end function hex

    !> How often a word stands in a text.
    integer function count_of(text, word)
        character(*), intent(in) :: text, word
        integer :: at, next
        count_of = 0
        at = 1
        do
            next = index(text(at:), word)
            if (next == 0) return
            count_of = count_of + 1
            at = at + next
        end do
    end function count_of

    !> A new output.
    subroutine empty(out)
        type(output_type), intent(out) :: out
        call out%put('')
    end subroutine empty

end program test_stl
