!> The listing of a cut: plane, outlines, rows, notes.
program test_cut_listing
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_output, only: output_type
    use cut_outline, only: cut_type, note_type
    use cut_plane, only: oblique_plane, station_plane
    use geom_arc_point, only: slope_type
    use report_cut_listing, only: print_cut
    use report_ordinate, only: new_form
    use report_page, only: page_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(cut_type) :: cut
    type(error_type), allocatable :: error
    character(:), allocatable :: text
    integer :: i
    logical :: whole

    cut%plane = station_plane(20.0_dp)
    cut%name = 'FRAME3'
    cut%disagreement = 1.5e-13_dp
    allocate (cut%outlines(0), cut%notes(0))
    text = listing()
    call tap%has(text, &
        'CUT 7   STATION 20.000   FRAME3   FLANGE AFT', 'number, plane, name and flange')
    call tap%has(text, 'DOES NOT MEET', 'a plane that misses says so')

    deallocate (cut%outlines)
    allocate (cut%outlines(1))
    allocate (cut%outlines(1)%points(2))
    associate (point => cut%outlines(1)%points)
        point%section = [1, 2]
        point(1)%at = [20.0_dp, 0.0_dp, -18.0_dp]
        point(2)%at = [20.0_dp, 12.5_dp, -7.1_dp]
        point(2)%has_slope = .true.
        point(2)%slope = slope_type(0.0_dp, .true.)
        point(2)%has_curvature = .true.
        point(2)%curvature = 0.125_dp
        point(2)%has_normal = .true.
        point(2)%bevel = -4.25_dp
        point(1)%uv = [0.0_dp, -18.0_dp]
    end associate
    cut%notes = [note_type(.false., 'THE SKIN IS THICKER THAN A RADIUS OF CURVATURE')]
    text = listing()
    call tap%has(text, 'OUTLINE 1 OF 1, OPEN', 'an outline says whether it is closed')
    call tap%has(text, 'SECTION LOWER', 'the section is named')
    call tap%has(text, 'SECTION UPPER', 'and again where it changes')
    call tap%has(text, '     20.000      0.000    -18.000', 'a row has STA, BL and WL')
    call tap%has(text, '     20.000     12.500     -7.100   VERTICAL       8.000   -4.250', &
        'slope, radius and bevel stand behind them')
    call tap%has(text, 'AGREE WITHIN 1.5E-13', 'how well the two ways agree is said')
    call tap%has(text, 'NOTE:  THE SKIN IS THICKER', 'notes stand below')

    cut%skin = 0.05_dp
    cut%inside = cut%outlines
    do i = 12, 24
        text = paged_listing(i)
        whole = index(text, 'INSIDE OF SKIN, 0.050 THICK: OUTLINE 1 OF 1'//new_line('a')// &
            '        STA') > 0
        if (.not. whole) exit
    end do
    call tap%ok(whole, 'the heading of the inside stays with its table on any page')

    call oblique_plane([20.0_dp, -16.0_dp], [30.0_dp, -6.0_dp], cut%plane, error)
    text = listing()
    call tap%has(text, 'OBLIQUE FRAME', 'an oblique frame is called one')
    call tap%has(text, 'U = V = 0 AT  STA', 'its origin is stated')
    call tap%has(text, 'U AXIS (', 'and its axes')
    call tap%has(text, '         U         V       STA', 'its true shape stands in front')
    call tap%finish()

contains

    !> The listing of the cut on pages of some lines.
    function paged_listing(lines) result(text)
        integer, intent(in) :: lines !! of a page
        character(:), allocatable :: text
        type(page_type) :: page
        type(output_type) :: out
        call page%set_heading('TITLE', 'deck.crd', 'INCHES')
        call page%set_size(80, lines)
        call print_cut(page, 7, cut, ['LOWER', 'UPPER'], new_form('INCHES', 'INCHES', 3), out)
        text = out%text()
    end function paged_listing

    !> The listing of the cut as number 7.
    function listing() result(text)
        character(:), allocatable :: text
        type(page_type) :: page
        type(output_type) :: out
        call page%set_heading('TITLE', 'deck.crd', 'INCHES')
        call print_cut(page, 7, cut, [character(8) :: 'LOWER', 'UPPER'], &
            new_form('INCHES', 'INCHES', 3), out)
        text = out%text()
    end function listing

end program test_cut_listing
