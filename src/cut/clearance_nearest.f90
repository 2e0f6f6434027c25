!> The point of the skin nearest to a point or a box with faces along the axes (a point is a box
!> without size). From every sample of the skin that is nearer than its neighbours, and not farther
!> than the nearest by more than the grid's spacing, Newton's method goes down to the nearest point
!> thereabouts; the edges of sheets are bounds that it may run along. The nearest of all is taken.
!> This finds every hollow of the distance that the grid of `cut_clearance_map` can tell apart.
module cut_clearance_nearest
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_tolerances, only: decimal_noise, foot_tolerance, ulp
    use body_body, only: body_type
    use body_skin, only: skin_at, skin_type
    use cut_clearance_map, only: column_parts, map_type, row_parts, sheet_type
    use cut_clearance_step, only: step_towards
    use cut_measure_sheet, only: frame_at, frame_type, spot_at, spot_type, station_of
    use geom_place, only: place_at
    implicit none (type, external)
    private

    public :: box_type, foot_type, nearest_to, reach_of

    !> What the way is reckoned from.
    type :: box_type
        real(dp) :: lower(3) = 0.0_dp !! least STA, BL, WL, deck units
        real(dp) :: upper(3) = 0.0_dp !! greatest STA, BL, WL, deck units
    end type box_type

    !> A nearest point of the skin.
    type :: foot_type
        logical :: exists = .false.         !! there is any skin
        real(dp) :: distance = huge(1.0_dp) !! from the box, deck units; 0 inside of it
        real(dp) :: at(3) = 0.0_dp          !! on the skin: STA, BL, WL, deck units
        real(dp) :: touching(3) = 0.0_dp    !! the point of the box that is nearest to it
        integer :: section = 0              !! place in the body's list of sections
        logical :: has_normal = .false.     !! the skin has a normal there
        real(dp) :: normal(3) = 0.0_dp      !! outward, of unit length; the mean where sheets meet
    end type foot_type

    !> A try for a nearest point.
    type :: try_type
        type(foot_type) :: foot             !! what it has found
        real(dp) :: place(2) = 0.0_dp       !! u and t
        real(dp) :: least(2) = 0.0_dp       !! bounds of u and t
        real(dp) :: most(2) = 1.0_dp        !! bounds of u and t
        type(spot_type) :: spot             !! the skin there
        real(dp) :: way(3) = 0.0_dp         !! r
        logical :: is_out(3) = .false.      !! outside of the box's slab along the axis
    end type try_type

    !> How near to an end where a sheet is not smooth Newton's method goes, in u; the end itself is
    !> tried apart. In STA it is the square of this.
    real(dp), parameter :: rim = 1.0e-6_dp
    !> Steps of one try, and halvings of one step.
    integer, parameter :: most_steps = 60, most_halvings = 40

contains

    !> The nearest point of the skin. `exists` is false where there is no skin.
    pure subroutine nearest_to(body, map, box, foot)
        type(body_type), intent(in) :: body     !! finished
        type(map_type), intent(in) :: map       !! its samples
        type(box_type), intent(in) :: box       !! a box or a point
        type(foot_type), intent(out) :: foot    !! the nearest
        type(foot_type), allocatable :: feet(:)
        real(dp) :: away(0:column_parts, 0:row_parts, size(map%sheets)), least
        integer :: i, k, row

        do i = 1, size(map%sheets)
            call measure_samples(map%sheets(i), box, away(:, :, i))
        end do
        least = minval(away)
        allocate (feet(0))
        do i = 1, size(map%sheets)
            do row = 0, row_parts
                do k = 0, column_parts
                    if (away(k, row, i) - map%sheets(i)%spacing > least) cycle
                    if (.not. is_least(away(:, :, i), k, row)) cycle
                    call try_from(body, map%sheets(i), box, [row, k], feet)
                end do
            end do
        end do
        if (size(feet) == 0) return
        foot = feet(minloc(feet%distance, dim=1))
        call face(feet, foot)
    end subroutine nearest_to

    !> The distance of the nearest sample of the skin from a point, or from its image where it is to
    !> port of a symmetric body: the skin is not farther. Huge where there is no skin.
    pure real(dp) function reach_of(body, map, point) result(reach)
        type(body_type), intent(in) :: body     !! finished
        type(map_type), intent(in) :: map       !! its samples
        real(dp), intent(in) :: point(3)        !! STA, BL, WL, deck units
        real(dp) :: square, seen(3)
        integer :: i, k, row

        square = huge(1.0_dp)
        seen = point
        if (body%is_symmetric) seen(2) = abs(seen(2))
        do i = 1, size(map%sheets)
            do row = 0, row_parts
                if (.not. map%sheets(i)%is_there(row)) cycle
                do k = 0, column_parts
                    square = min(square, sum((map%sheets(i)%at(:, k, row) - seen)**2))
                end do
            end do
        end do
        reach = sqrt(square)
    end function reach_of

    !> How far the samples of a sheet are from a box.
    pure subroutine measure_samples(sheet, box, away)
        type(sheet_type), intent(in) :: sheet       !! its samples
        type(box_type), intent(in) :: box           !! a box or a point
        real(dp), intent(out) :: away(0:, 0:)       !! by t and u, deck units; huge where no skin is
        integer :: k, row

        away = huge(1.0_dp)
        do row = 0, row_parts
            if (.not. sheet%is_there(row)) cycle
            do k = 0, column_parts
                away(k, row) = norm2(sheet%at(:, k, row) - clamped(sheet%at(:, k, row), box))
            end do
        end do
    end subroutine measure_samples

    !> The point of a box nearest to a point.
    pure function clamped(point, box) result(nearest)
        real(dp), intent(in) :: point(3)    !! STA, BL, WL
        type(box_type), intent(in) :: box   !! a box or a point
        real(dp) :: nearest(3)
        nearest = min(max(point, box%lower), box%upper)
    end function clamped

    !> True for a sample that none of its neighbours is nearer than, along its row or in the grid.
    pure logical function is_least(away, k, row)
        real(dp), intent(in) :: away(0:, 0:)    !! of one sheet, by t and u
        integer, intent(in) :: k                !! which t
        integer, intent(in) :: row              !! which u
        integer :: first, last

        is_least = .false.
        if (.not. away(k, row) < huge(1.0_dp)) return
        first = max(row - 1, 0)
        last = min(row + 1, row_parts)
        if (row == 0 .or. row == row_parts) then
            first = row
            last = row
        end if
        is_least = away(k, row) <= minval(away(max(k - 1, 0):min(k + 1, column_parts), first:last))
    end function is_least

    !> Goes down from a sample; from one at the end of a sheet both along that end and inwards.
    pure subroutine try_from(body, sheet, box, sample, feet)
        type(body_type), intent(in) :: body                     !! finished
        type(sheet_type), intent(in) :: sheet                   !! a sheet
        type(box_type), intent(in) :: box                       !! a box or a point
        integer, intent(in) :: sample(2)                        !! row and column of the sample
        type(foot_type), allocatable, intent(inout) :: feet(:)  !! gets what was found
        type(try_type) :: try

        try%place = real(sample, dp)/real([row_parts, column_parts], dp)
        if (sample(1) == 0 .or. sample(1) == row_parts) then
            try%least(1) = try%place(1)
            try%most(1) = try%place(1)
            if (sheet%is_point(sample(1))) then
                try%spot%at = sheet%at(:, sample(2), sample(1))
                call take(try, sheet, box)
            else
                call go_down(body, sheet, box, try)
            end if
            if (try%foot%exists) feet = [feet, with_normal(body, sheet, try)]
            try = try_type(place=[abs(try%place(1) - 0.5_dp/real(row_parts, dp)), try%place(2)])
        end if
        if (sheet%span%is_blunt(1) .or. sheet%is_point(0)) try%least(1) = rim
        if (sheet%span%is_blunt(2) .or. sheet%is_point(row_parts)) try%most(1) = 1.0_dp - rim
        try%place = min(max(try%place, try%least), try%most)
        call go_down(body, sheet, box, try)
        if (try%foot%exists) feet = [feet, with_normal(body, sheet, try)]
    end subroutine try_from

    !> Newton's method with halved steps, within the bounds.
    pure subroutine go_down(body, sheet, box, try)
        type(body_type), intent(in) :: body     !! finished
        type(sheet_type), intent(in) :: sheet   !! a sheet
        type(box_type), intent(in) :: box       !! a box or a point
        type(try_type), intent(inout) :: try    !! has place and bounds; gets what is found
        type(try_type) :: next
        real(dp) :: step(2), part, noise
        integer :: i, k

        call look(body, sheet, box, try)
        do i = 1, most_steps
            if (.not. try%foot%exists .or. .not. try%foot%distance > 0.0_dp) return
            step = step_towards(try%spot, try%way, try%is_out, &
                can_fall=try%place > try%least, can_rise=try%place < try%most)
            part = 1.0_dp
            do k = 1, most_halvings
                next = try
                next%place = min(max(try%place + part*step, try%least), try%most)
                call look(body, sheet, box, next)
                noise = decimal_noise*ulp*maxval(abs(try%foot%at))
                if (next%foot%exists .and. &
                    next%foot%distance <= try%foot%distance + noise) exit
                part = 0.5_dp*part
            end do
            if (k > most_halvings) return
            step = next%place - try%place
            try = next
            if (maxval(abs(step)) <= foot_tolerance) return
        end do
    end subroutine go_down

    !> Looks at the skin at the place of a try.
    pure subroutine look(body, sheet, box, try)
        type(body_type), intent(in) :: body     !! finished
        type(sheet_type), intent(in) :: sheet   !! a sheet
        type(box_type), intent(in) :: box       !! a box or a point
        type(try_type), intent(inout) :: try    !! has its place
        type(frame_type) :: frame
        type(error_type), allocatable :: error

        try%foot%exists = .false.
        call frame_at(body, body%sections(sheet%section), station_of(sheet%span, try%place(1)), &
            frame, error)
        if (allocated(error)) return
        try%spot = spot_at(frame, try%place(2))
        call take(try, sheet, box)
    end subroutine look

    !> Takes the point of a try as its foot.
    pure subroutine take(try, sheet, box)
        type(try_type), intent(inout) :: try    !! has its point
        type(sheet_type), intent(in) :: sheet   !! where it is
        type(box_type), intent(in) :: box       !! a box or a point
        try%foot%exists = .true.
        try%foot%section = sheet%section
        try%foot%at = try%spot%at
        try%foot%touching = clamped(try%spot%at, box)
        try%way = try%foot%at - try%foot%touching
        try%is_out = try%spot%at <= box%lower .or. try%spot%at >= box%upper
        try%foot%distance = norm2(try%way)
    end subroutine take

    !> The foot of a try with the normal of the skin: at a joint of lines that of its own sheet.
    pure type(foot_type) function with_normal(body, sheet, try) result(foot)
        type(body_type), intent(in) :: body     !! finished
        type(sheet_type), intent(in) :: sheet   !! where the try is
        type(try_type), intent(in) :: try       !! with a foot
        type(skin_type) :: skin
        real(dp) :: sta

        foot = try%foot
        associate (section => body%sections(foot%section), span => sheet%span)
            sta = foot%at(1)
            if (sta >= span%to .and. sta < section%to) &
                sta = span%to - foot_tolerance*max(abs(span%to), span%to - span%from)
            skin = skin_at(body%lines, section, sta, place_at(try%place(2)))
        end associate
        foot%has_normal = skin%has_normal
        foot%normal = skin%normal
    end function with_normal

    !> Gives the nearest foot the mean normal of all feet that are the same point.
    pure subroutine face(feet, foot)
        type(foot_type), intent(in) :: feet(:)  !! all that were found
        type(foot_type), intent(inout) :: foot  !! the nearest of them
        real(dp) :: same, mean(3)
        integer :: i

        same = sqrt(ulp)*max(maxval(abs(foot%at)), foot%distance)
        mean = 0.0_dp
        do i = 1, size(feet)
            if (feet(i)%has_normal .and. norm2(feet(i)%at - foot%at) <= same) &
                mean = mean + feet(i)%normal
        end do
        foot%has_normal = norm2(mean) > 0.0_dp
        if (foot%has_normal) foot%normal = mean/norm2(mean)
    end subroutine face

end module cut_clearance_nearest
