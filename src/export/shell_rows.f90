!> A section at a station as the rows of a rational Bezier curve, in homogeneous coordinates: its
!> start with weight 1, V1 with weight w, its finish with weight 1, where in terms of `geom_arc`
!> V1 = w m + g. Along the body each row is a smooth function of u.
!>
!> Where w is small or below zero it can't be the weight of a pole. Halved without roots the curve
!> has the rows P0, (P0 + V1)/2, (P0 + 2 V1 + P2)/4, (V1 + P2)/2, P2 with the weights 1, q/2, q/2,
!> q/2, 1, and q = 1 + w is above zero.
module export_shell_rows
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_section, only: section_arc
    use body_taylor, only: taylor_type
    use export_shell_pace, only: station_at
    use export_shell_stretch, only: slot_type, stretch_type, track_at
    use geom_arc, only: arc_type, weight
    use geom_twofold, only: to_real
    implicit none (type, external)
    private

    public :: rows_type, rows_at, poles_of, pole_count, forms_of

    !> The rows of a section at a station: BL and WL, deck units.
    type :: rows_type
        real(dp) :: start(2) = 0.0_dp       !! P0
        real(dp) :: middle(2) = 0.0_dp      !! V1
        real(dp) :: finish(2) = 0.0_dp      !! P2
        real(dp) :: weight = 1.0_dp         !! w, above -1
        logical :: is_line = .false.        !! a straight line
    end type rows_type

    !> How a section is written in poles.
    type, public :: form_list
        integer :: line = 1     !! straight at all stations: degree 1
        integer :: arc = 2      !! one rational quadratic
        integer :: halves = 3   !! two
    end type form_list

    !> The forms by name; of two that meet the greater one serves both.
    type(form_list), parameter, public :: form = form_list()

    !> The least w of a pole.
    real(dp), parameter :: least_weight = 0.2_dp
    !> Places of a stretch at which w is looked at.
    integer, parameter :: places = 33

contains

    !> The rows of a section inside of a stretch. Fails as `section_arc` where it has no arc.
    pure subroutine rows_at(stretch, slot, sta, rows, error)
        type(stretch_type), intent(in) :: stretch           !! any
        type(slot_type), intent(in) :: slot                 !! one of its slots
        real(dp), intent(in) :: sta                         !! deck units
        type(rows_type), intent(out) :: rows                !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        type(arc_type) :: arc

        rows%start = track_at(stretch, stretch%tracks(slot%track(1)), sta)
        rows%finish = track_at(stretch, stretch%tracks(slot%track(2)), sta)
        rows%middle = 0.5_dp*(rows%start + rows%finish)
        rows%is_line = .true.
        if (slot%number == 0) return
        call section_arc(stretch%body%lines, slot%section, sta, arc, error)
        if (allocated(error) .or. arc%is_line) return
        rows%is_line = .false.
        rows%weight = weight(arc)
        rows%middle = rows%weight*rows%middle + arc%size*to_real(arc%bulge)
    end subroutine rows_at

    !> The rows in the order of the way around: BL, WL and weight of each pole, homogeneous.
    pure function poles_of(start, middle, finish, which) result(poles)
        real(dp), intent(in) :: start(:)    !! P0 with its weight behind it
        real(dp), intent(in) :: middle(:)   !! V1 too
        real(dp), intent(in) :: finish(:)   !! P2 too
        integer, intent(in) :: which        !! one of `form%...`
        real(dp) :: poles(size(start), pole_count(which))

        poles(:, 1) = start
        select case (which)
        case (form%arc)
            poles(:, 2) = middle
        case (form%halves)
            poles(:, 2) = 0.5_dp*(start + middle)
            poles(:, 3) = 0.25_dp*(start + finish) + 0.5_dp*middle
            poles(:, 4) = 0.5_dp*(middle + finish)
        end select
        poles(:, size(poles, 2)) = finish
    end function poles_of

    !> How many poles a form has around a section.
    pure integer function pole_count(which)
        integer, intent(in) :: which !! one of `form%...`
        pole_count = max(2, 2*which - 1)
    end function pole_count

    !> How each section of a body is best written, the same in all of its stretches.
    pure function forms_of(stretches, sections) result(forms)
        type(stretch_type), intent(in) :: stretches(:)  !! of the body
        integer, intent(in) :: sections                 !! how many it has
        integer :: forms(sections)
        type(rows_type) :: rows
        type(error_type), allocatable :: error
        type(taylor_type) :: sta
        integer :: i, k, m

        forms = form%line
        do i = 1, size(stretches)
            do k = 1, size(stretches(i)%slots)
                associate (slot => stretches(i)%slots(k))
                    if (slot%number == 0) cycle
                    do m = 1, places
                        sta = station_at(stretches(i)%pace, real(m, dp)/real(places + 1, dp))
                        call rows_at(stretches(i), slot, sta%value, rows, error)
                        if (allocated(error)) cycle
                        forms(slot%number) = max(forms(slot%number), form_of(rows))
                    end do
                end associate
            end do
        end do
    end function forms_of

    !> How a section is best written at a station.
    pure integer function form_of(rows)
        type(rows_type), intent(in) :: rows !! any
        form_of = form%arc
        if (rows%is_line) form_of = form%line
        if (rows%weight < least_weight) form_of = form%halves
    end function form_of

end module export_shell_rows
