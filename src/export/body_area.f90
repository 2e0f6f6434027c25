!> The curve of section areas over the stations, with volume and centroid; of a body whose sections
!> do not close the curve of their girths.
!>
!> Between stations where lines join or end the curve is halved until its chords are close to it.
module export_body_area
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_measure, only: measure_section, section_measure_type
    use cut_measure_body, only: body_measure_type, stops_of
    use export_body_drawing, only: drawing_type, mark_of, word_side
    implicit none (type, external)
    private

    public :: area_drawing, figures

    !> Dots of the box between the axes.
    real(dp), parameter :: box(2) = [760.0_dp, 400.0_dp]
    !> How far the curve may be from a chord, in parts of the greatest value; how often a stretch is
    !> halved at least and at most.
    real(dp), parameter :: largest_height = 1.0e-3_dp
    integer, parameter :: least_halvings = 3, most_halvings = 12
    !> How far inside of an end it is measured where it can't be at the end: parts of the stretch.
    real(dp), parameter :: inside = 1.0e-7_dp
    !> Room above the curve, in parts of its height.
    real(dp), parameter :: margin = 0.12_dp

    !> Dots from a point to its words, to the side and upwards.
    real(dp), parameter :: beside(2) = [5.0_dp, 9.0_dp]

    !> What is drawn, over the stations.
    type :: curve_type
        logical :: is_area = .false.        !! areas, else girths
        real(dp), allocatable :: at(:, :)   !! station and value, by columns
        real(dp) :: greatest = 0.0_dp       !! value
    end type curve_type

contains

    !> The picture of the areas of a body; without layers where it has neither areas nor girths.
    pure type(drawing_type) function area_drawing(body, measure, stations, heading, unit) &
        result(drawing)
        type(body_type), intent(in) :: body             !! finished
        type(body_measure_type), intent(in) :: measure  !! of it
        real(dp), intent(in) :: stations(:)             !! marked on the curve, deck units
        character(*), intent(in) :: heading             !! title of the deck
        character(*), intent(in) :: unit                !! name of its unit
        type(curve_type) :: curve
        integer :: i

        drawing%script = 'chart'
        drawing%heading = heading
        drawing%note = ''
        drawing%view = ''
        drawing%x_axis = 'station (STA), '//unit
        drawing%y_axis = ''
        curve%is_area = any(measure%curve%has_area .and. measure%curve%area > 0.0_dp)
        if (curve%is_area) curve%greatest = maxval(measure%curve%area, mask=measure%curve%has_area)
        if (.not. curve%is_area .and. any(measure%curve%has_girth)) &
            curve%greatest = maxval(measure%curve%girth, mask=measure%curve%has_girth)
        if (.not. curve%greatest > 0.0_dp) return
        call follow_curve(body, curve)
        if (size(curve%at, 2) == 0) return
        drawing%low = [measure%from, 0.0_dp]
        drawing%high = [measure%to, (1.0_dp + margin)*curve%greatest]
        drawing%dot = (drawing%high - drawing%low)/box
        call drawing%draw('curve', curve%at)
        do i = 1, size(stations)
            call mark_station(body, curve, stations(i), drawing)
        end do
        call name_curve(curve, measure, unit, drawing)
    end function area_drawing

    !> Says what the curve is, and shows the centroid where there is one.
    pure subroutine name_curve(curve, measure, unit, drawing)
        type(curve_type), intent(in) :: curve           !! what is drawn
        type(body_measure_type), intent(in) :: measure  !! of the body
        character(*), intent(in) :: unit                !! name of the unit
        type(drawing_type), intent(inout) :: drawing    !! gets it

        drawing%y_axis = 'area of the whole section, square '//unit
        if (.not. curve%is_area) then
            drawing%view = 'Girth of the sections'
            drawing%y_axis = 'girth of the whole section, '//unit
            if (allocated(measure%why)) drawing%view = drawing%view//'; no area: '//measure%why
            return
        end if
        drawing%view = 'Section areas'
        if (.not. measure%has_volume) return
        drawing%view = drawing%view//'; volume '//figures(measure%volume)//' cubic '//unit// &
            ', centroid STA '//figures(measure%centroid(1))//', BL '// &
            figures(measure%centroid(2))//', WL '//figures(measure%centroid(3))
        call drawing%draw('centroid', reshape([measure%centroid(1), 0.0_dp, measure%centroid(1), &
            drawing%high(2)], [2, 2]))
        call drawing%write_words('centroid', [measure%centroid(1) + 6.0_dp*drawing%dot(1), &
            0.5_dp*margin*curve%greatest], word_side%right, 0)
    end subroutine name_curve

    !> A number to six figures.
    pure function figures(value) result(text)
        real(dp), intent(in) :: value !! a finite number
        character(:), allocatable :: text
        character(14) :: field
        real(dp) :: rounded
        real(dp), parameter :: least = 1.0e-6_dp
        write (field, '(es14.5e3)') value
        read (field, *) rounded
        if (abs(rounded) < least) rounded = 0.0_dp
        text = mark_of(rounded)
    end function figures

    !> Marks a station on the curve, where it has a value.
    pure subroutine mark_station(body, curve, sta, drawing)
        type(body_type), intent(in) :: body             !! finished
        type(curve_type), intent(in) :: curve           !! what is drawn
        real(dp), intent(in) :: sta                     !! deck units
        type(drawing_type), intent(inout) :: drawing    !! gets the mark
        real(dp) :: value
        logical :: has_value, is_before

        call value_at(body, curve%is_area, sta, value, has_value)
        if (.not. has_value) return
        call drawing%draw('point', reshape([sta, value], [2, 1]))
        is_before = sta < curve%at(1, maxloc(curve%at(2, :), dim=1))
        call drawing%write_where_free(mark_of(sta), reshape([sta, value] + beside*drawing%dot* &
            [merge(-1.0_dp, 1.0_dp, is_before), 1.0_dp], [2, 1]), &
            merge(word_side%left, word_side%right, is_before))
    end subroutine mark_station

    !> The value at a station.
    pure subroutine value_at(body, is_area, sta, value, has_value)
        type(body_type), intent(in) :: body     !! finished
        logical, intent(in) :: is_area          !! the area, else the girth
        real(dp), intent(in) :: sta             !! deck units
        real(dp), intent(out) :: value          !! where there is one, else zero
        logical, intent(out) :: has_value       !! there is one
        type(section_measure_type) :: measure

        call measure_section(body, sta, measure)
        has_value = merge(measure%has_area, measure%has_girth, is_area)
        value = merge(measure%area, measure%girth, is_area)
    end subroutine value_at

    !> Follows the curve from stop to stop.
    pure subroutine follow_curve(body, curve)
        type(body_type), intent(in) :: body         !! finished
        type(curve_type), intent(inout) :: curve    !! gets its points
        real(dp), allocatable :: stops(:)
        real(dp) :: ends(2, 2)
        logical :: has_both(2)
        integer :: i

        allocate (curve%at(2, 0))
        allocate (stops(0))
        stops = stops_of(body)
        do i = 2, size(stops)
            call end_value(body, curve%is_area, stops(i - 1), stops(i), ends(:, 1), has_both(1))
            call end_value(body, curve%is_area, stops(i), stops(i - 1), ends(:, 2), has_both(2))
            if (.not. all(has_both)) cycle
            call add(curve, ends(:, 1))
            call halve(body, curve, ends(:, 1), ends(:, 2), 0)
            call add(curve, ends(:, 2))
        end do
    end subroutine follow_curve

    !> The value at an end of a stretch, or a little inside of it.
    pure subroutine end_value(body, is_area, sta, other, at, has_value)
        type(body_type), intent(in) :: body     !! finished
        logical, intent(in) :: is_area          !! the area, else the girth
        real(dp), intent(in) :: sta             !! the end, deck units
        real(dp), intent(in) :: other           !! the other end, deck units
        real(dp), intent(out) :: at(2)          !! station and value
        logical, intent(out) :: has_value       !! there is one

        at(1) = sta + inside*(other - sta)
        call value_at(body, is_area, at(1), at(2), has_value)
    end subroutine end_value

    !> Puts the points between two others to a curve.
    pure recursive subroutine halve(body, curve, before, after, halving)
        type(body_type), intent(in) :: body         !! finished
        type(curve_type), intent(inout) :: curve    !! gets them
        real(dp), intent(in) :: before(2)           !! station and value
        real(dp), intent(in) :: after(2)            !! station and value
        integer, intent(in) :: halving              !! how often it was halved before
        real(dp) :: middle(2)
        logical :: has_value, is_close

        middle(1) = 0.5_dp*(before(1) + after(1))
        call value_at(body, curve%is_area, middle(1), middle(2), has_value)
        if (.not. has_value) return
        is_close = abs(middle(2) - 0.5_dp*(before(2) + after(2))) <= largest_height*curve%greatest
        if (halving >= most_halvings .or. (is_close .and. halving >= least_halvings)) return
        call halve(body, curve, before, middle, halving + 1)
        call add(curve, middle)
        call halve(body, curve, middle, after, halving + 1)
    end subroutine halve

    !> Puts a point to a curve.
    pure subroutine add(curve, at)
        type(curve_type), intent(inout) :: curve    !! gets it
        real(dp), intent(in) :: at(2)               !! station and value
        curve%at = reshape([curve%at, at], [2, size(curve%at, 2) + 1])
    end subroutine add

end module export_body_area
