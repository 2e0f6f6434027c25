!> The entities of a DXF file: POINT, LINE, POLYLINE, LWPOLYLINE, SPLINE and TEXT.
!>
!> Source: Autodesk, "DXF Reference" for release 12 and for AutoCAD 2000, ENTITIES section.
module export_dxf_entity
    use base_exact, only: is_equal, is_zero
    use base_kinds, only: dp
    use export_dxf_page, only: words_type
    use export_dxf_tag, only: dxf_type
    use export_dxf_text, only: dxf_text
    use geom_bspline, only: bspline_type, is_rational
    implicit none (type, external)
    private

    public :: put_point, put_line, put_polyline, put_light_polyline, put_spline, put_words, on_page

    !> How near poles or knots are one for a reader of a spline.
    real(dp), parameter :: pole_tolerance = 1.0e-10_dp
    !> Normal of the page of a drawing in space: to port.
    real(dp), parameter :: to_port(3) = [0.0_dp, -1.0_dp, 0.0_dp]

contains

    !> A place of the page in the drawing: itself, or of the plane of BL 0.
    pure function on_page(at, is_in_space) result(place)
        real(dp), intent(in) :: at(2)       !! on the page
        logical, intent(in) :: is_in_space  !! the page is BL 0
        real(dp), allocatable :: place(:)
        allocate (place(2))
        place = at
        if (is_in_space) place = [at(1), 0.0_dp, at(2)]
    end function on_page

    !> Puts a point.
    subroutine put_point(file, layer, at)
        type(dxf_type), intent(inout) :: file   !! the file
        character(*), intent(in) :: layer       !! its name
        real(dp), intent(in) :: at(:)           !! shape (2) or (3)
        call file%new('POINT', layer)
        call file%class('AcDbPoint')
        call file%point(10, at)
    end subroutine put_point

    !> Puts a straight line.
    subroutine put_line(file, layer, from, to)
        type(dxf_type), intent(inout) :: file   !! the file
        character(*), intent(in) :: layer       !! its name
        real(dp), intent(in) :: from(:)         !! shape (2) or (3)
        real(dp), intent(in) :: to(:)           !! shape as `from`
        call file%new('LINE', layer)
        call file%class('AcDbLine')
        call file%point(10, from)
        call file%point(11, to)
    end subroutine put_line

    !> Puts a polygon, or arcs end to end, as one entity.
    subroutine put_polyline(file, layer, at, is_closed, bulge)
        type(dxf_type), intent(inout) :: file   !! of R12
        character(*), intent(in) :: layer       !! its name
        real(dp), intent(in) :: at(:, :)        !! corners by columns, shape (2, n) or (3, n)
        logical, intent(in) :: is_closed        !! the last is joined to the first
        real(dp), intent(in), optional :: bulge(:)  !! of the arc from each corner on, in a plane:
                                                    !! tan(turn/4), positive to the left
        integer, parameter :: closed = 1, in_space = 8, corner_in_space = 32
        logical :: is_flat
        integer :: i

        is_flat = size(at, 1) == 2
        call file%new('POLYLINE', layer)
        call file%tag(66, 1)
        call file%point(10, [0.0_dp, 0.0_dp, 0.0_dp])
        call file%tag(70, merge(closed, 0, is_closed) + merge(0, in_space, is_flat))
        do i = 1, size(at, 2)
            call file%new('VERTEX', layer)
            call file%point(10, at(:, i))
            if (.not. is_flat) call file%tag(70, corner_in_space)
            if (.not. present(bulge)) cycle
            if (.not. is_zero(bulge(i))) call file%tag(42, bulge(i))
        end do
        call file%new('SEQEND', layer)
    end subroutine put_polyline

    !> Puts arcs end to end as one entity of R2000.
    subroutine put_light_polyline(file, layer, at, is_closed, bulge)
        type(dxf_type), intent(inout) :: file   !! of R2000
        character(*), intent(in) :: layer       !! its name
        real(dp), intent(in) :: at(:, :)        !! corners by columns, shape (2, n)
        logical, intent(in) :: is_closed        !! the last is joined to the first
        real(dp), intent(in) :: bulge(:)        !! of the arc from each corner on: tan(turn/4),
                                                !! positive to the left
        integer :: i

        call file%new('LWPOLYLINE', layer)
        call file%class('AcDbPolyline')
        call file%tag(90, size(at, 2))
        call file%tag(70, merge(1, 0, is_closed))
        do i = 1, size(at, 2)
            call file%vector(10, at(:, i))
            if (.not. is_zero(bulge(i))) call file%tag(42, bulge(i))
        end do
    end subroutine put_light_polyline

    !> Puts a B-spline, which is exactly what it is.
    subroutine put_spline(file, layer, spline, normal)
        type(dxf_type), intent(inout) :: file       !! of R2000
        character(*), intent(in) :: layer           !! its name
        type(bspline_type), intent(in) :: spline    !! in the plane or in space
        real(dp), intent(in) :: normal(3)           !! of its plane, unit vector; zero: it has none
        integer, parameter :: closed = 1, rational = 4, planar = 8
        integer :: flags, last, i
        logical :: has_plane, has_weights

        last = size(spline%pole, 2)
        has_plane = .not. all(is_zero(normal))
        has_weights = is_rational(spline)
        flags = merge(planar, 0, has_plane) + merge(rational, 0, has_weights)
        if (all(is_equal(spline%pole(:, 1), spline%pole(:, last)))) flags = flags + closed
        call file%new('SPLINE', layer)
        call file%class('AcDbSpline')
        if (has_plane) call file%vector(210, normal)
        call file%tag(70, flags)
        call file%tag(71, spline%degree)
        call file%tag(72, size(spline%knot))
        call file%tag(73, last)
        call file%tag(74, 0)
        call file%tag(42, pole_tolerance)
        call file%tag(43, pole_tolerance)
        do i = 1, size(spline%knot)
            call file%tag(40, spline%knot(i))
        end do
        if (has_weights) then
            do i = 1, last
                call file%tag(41, spline%weight(i))
            end do
        end if
        do i = 1, last
            call file%point(10, spline%pole(:, i))
        end do
    end subroutine put_spline

    !> Puts words, upright on the page.
    subroutine put_words(file, layer, words, height, is_in_space)
        type(dxf_type), intent(inout) :: file   !! the file
        character(*), intent(in) :: layer       !! its name
        type(words_type), intent(in) :: words   !! what and where
        real(dp), intent(in) :: height          !! of the letters
        logical, intent(in) :: is_in_space      !! the page is BL 0
        integer, parameter :: half_height = 2

        call file%new('TEXT', layer)
        call file%class('AcDbText')
        call file%point(10, words%at)
        call file%tag(40, height)
        call file%tag(1, dxf_text(words%text))
        call file%tag(72, words%side)
        call file%point(11, words%at)
        if (is_in_space) call file%vector(210, to_port)
        call file%class('AcDbText')
        call file%tag(73, half_height)
    end subroutine put_words

end module export_dxf_entity
