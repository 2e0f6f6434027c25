!> Tests of patterns laid out from a drawing.
program test_pattern
    use base_error, only: error_type
    use base_kinds, only: dp
    use cut_plane, only: station_plane, waterline_plane
    use export_drawing, only: drawing_type, shape_type
    use export_pattern, only: lay_out
    use export_pattern_page, only: item_kind, page_type
    use export_pattern_style, only: style
    use export_receipt, only: receipt_type
    use export_settings, only: settings_type
    use support_shapes, only: add_circle, add_path, new_drawing, new_shape
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(shape_type) :: shapes(3)
    type(drawing_type) :: drawing
    type(settings_type) :: settings
    type(page_type), allocatable :: pages(:)
    type(receipt_type) :: receipt
    type(error_type), allocatable :: error

    shapes(1) = new_shape('STA_20', 'STATION 20', station_plane(20.0_dp))
    call add_circle(shapes(1), [0.0_dp, 0.0_dp], 10.0_dp, .false., 8)
    call add_circle(shapes(1), [0.0_dp, 0.0_dp], 9.9_dp, .true., 0)
    shapes(2) = new_shape('STA_40', 'STATION 40', station_plane(40.0_dp))
    shapes(2)%is_half = .true.
    call add_path(shapes(2), reshape([0.0_dp, -5.0_dp, 8.0_dp, -5.0_dp, 8.0_dp, 5.0_dp, 0.0_dp, &
        5.0_dp], [2, 4]))
    shapes(3) = new_shape('WL_90', 'WATERLINE 90', waterline_plane(90.0_dp))
    drawing = new_drawing(shapes)

    settings%is_each = .true.
    call lay_out(drawing, settings, pages, receipt, error)
    call tap%ok(.not. allocated(error), 'a drawing is laid out')
    call tap%ok(size(pages) == 2, 'a page for each cut that has an outline')
    call tap%has(receipt%notes, 'NO PATTERN OF WATERLINE 90', 'the receipt tells of the other')
    call tap%ok(receipt%count == 3, 'and has every contour')
    call tap%near(extent(pages(1), 1), 20.0_dp, 1.0e-3_dp, 'a circle is as wide as it is')
    call tap%near(extent(pages(2), 1), 16.0_dp, 1.0e-9_dp, 'of a half the whole is drawn')
    call tap%same(pages(2)%title, 'SHAPES OF CLOSED FORM, test.crd', 'pages know title and deck')
    settings%is_half = .true.
    call lay_out(drawing, settings, pages, receipt, error)
    call tap%near(extent(pages(2), 1), 8.0_dp, 1.0e-9_dp, 'or the half, where it is asked for')
    call tap%near(extent(pages(1), 1), 20.0_dp, 1.0e-3_dp, 'what is whole stays whole')

    settings%is_each = .false.
    call lay_out(drawing, settings, pages, receipt, error)
    call tap%ok(size(pages) == 1, 'all on one sheet')
    call tap%ok(pages(1)%group_count == 2, 'each a part of its own')
    settings%paper = 'letter'
    call lay_out(drawing, settings, pages, receipt, error)
    call tap%ok(size(pages) > 3 .and. all(abs(pages(2)%size - [8.5_dp, 11.0_dp]) < 1.0e-12_dp .or. &
        abs(pages(2)%size - [11.0_dp, 8.5_dp]) < 1.0e-12_dp), 'on letter it is tiled')
    settings%paper = 'roll'
    settings%roll_width = 30.0_dp
    call lay_out(drawing, settings, pages, receipt, error)
    call tap%ok(size(pages) == 1 .and. abs(pages(1)%size(1) - 30.0_dp) < 1.0e-12_dp, &
        'on a roll it is as wide as the roll')

    settings%roll_width = 16.0_dp
    call lay_out(drawing, settings, pages, receipt, error)
    call tap%ok(size(pages) == 4 .and. all([pages(2)%size(1), pages(3)%size(1)] < 16.1_dp) .and. &
        pages(1)%size(2) < pages(2)%size(2), 'what is wider is tiled in lengths, after a map')

    drawing%units = 'MM'
    settings = settings_type()
    call lay_out(drawing, settings, pages, receipt, error)
    call tap%near(extent(pages(1), 2), 20.0_dp/25.4_dp, 1.0e-3_dp, '20 mm are 0.787 in of paper')
    drawing%units = 'CUBITS'
    call lay_out(drawing, settings, pages, receipt, error)
    call tap%ok(allocated(error), 'a unit that is none is refused')
    drawing%units = 'INCHES'
    settings%paper = 'foolscap'
    call lay_out(drawing, settings, pages, receipt, error)
    call tap%ok(allocated(error), 'so is such paper')
    drawing%cuts = drawing%cuts(3:)
    settings = settings_type()
    call lay_out(drawing, settings, pages, receipt, error)
    call tap%ok(allocated(error), 'and a drawing without a cut')
    if (allocated(error)) call tap%has(error%message, 'there is no cut', 'which is said')
    call tap%finish()

contains

    !> Width or height of the first outline on a page, by its ends of arcs.
    real(dp) function extent(page, axis)
        type(page_type), intent(in) :: page     !! any
        integer, intent(in) :: axis             !! 1 or 2
        integer :: i
        extent = -1.0_dp
        do i = page%count, 1, -1
            associate (item => page%items(i))
                if (item%kind == item_kind%curves .and. item%style == style%outline) &
                    extent = maxval(item%at(axis, ::3)) - minval(item%at(axis, ::3))
            end associate
        end do
    end function extent

end program test_pattern
