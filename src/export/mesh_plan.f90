!> Where the rows and columns of a mesh are: stations along the body, common to all its sections,
!> and shares around each section, the same all along it. Both are spaced so that each step takes an
!> equal part of what `export_mesh_density` says is wanted.
module export_mesh_plan
    use base_constants, only: degrees
    use base_digits, only: shortest
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_order, only: rising
    use base_text, only: compact
    use body_taylor, only: taylor_type
    use cut_measure_sheet, only: station_of
    use export_mesh_density, only: density_type, need_type, stretch_type
    implicit none (type, external)
    private

    public :: run_type, plan_type, new_plan, station_plan

    !> Triangles of the largest mesh, both halves: beyond it a tolerance was surely mistyped, and no
    !> program would read the file.
    real(dp), parameter, public :: most_triangles = 4.0e6_dp

    !> Steps that no stretch and no section has fewer of: with them nothing with a volume comes out
    !> flat.
    integer, parameter :: least_steps = 2

    !> A count of steps that is whole but for rounding is that number.
    real(dp), parameter :: rounding = 1.0e-9_dp

    !> The rows of a stretch.
    type :: run_type
        type(stretch_type) :: stretch       !! stations, sections
        real(dp), allocatable :: u(:)       !! 0 to 1, both in it, rising
        real(dp), allocatable :: sta(:)     !! the station of each, deck units
    end type run_type

    !> The columns of a section.
    type :: column_type
        real(dp), allocatable :: share(:)   !! 0 to 1, both in it, rising
    end type column_type

    !> All of a body.
    type :: plan_type
        type(run_type), allocatable :: runs(:)          !! in order of stations, end to end
        type(column_type), allocatable :: columns(:)    !! of each section of the body
    end type plan_type

contains

    !> The rows and columns for a tolerance and an angle. Half of the tolerance is for the steps
    !> along, half for those around.
    !>
    !> Fails with `cause%too_many` where there would be more than `most_triangles`.
    pure subroutine new_plan(density, tolerance, angle, is_symmetric, plan, error)
        type(density_type), intent(in) :: density           !! of the body
        real(dp), intent(in) :: tolerance                   !! deck units, above zero
        real(dp), intent(in) :: angle                       !! degrees, above zero
        logical, intent(in) :: is_symmetric                 !! the port half doubles all
        type(plan_type), intent(out) :: plan                !! where there is no error
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: along, around, triangles
        integer :: i, k

        triangles = 0.0_dp
        do i = 1, size(density%stretches)
            associate (stretch => density%stretches(i))
                along = total(wanted(stretch%need, tolerance, angle))
                do k = 1, size(stretch%sections)
                    around = total(wanted(density%around(stretch%sections(k)), tolerance, angle))
                    triangles = triangles + 2.0_dp*(along + 1.0_dp)*(around + 1.0_dp)
                end do
            end associate
        end do
        if (is_symmetric) triangles = 2.0_dp*triangles
        if (triangles > most_triangles) then
            call fail(error, cause%too_many, 'the mesh would have '//shortest(anint(triangles))// &
                ' triangles, and LOFT makes no more than '//shortest(most_triangles)// &
                '; ask for a tolerance and an angle '//compact(triangles/most_triangles)// &
                ' times as large')
            return
        end if
        call lay_rows(density, tolerance, angle, plan%runs)
        call lay_columns(density, tolerance, angle, plan%columns)
    end subroutine new_plan

    !> The rows of all stretches.
    pure subroutine lay_rows(density, tolerance, angle, runs)
        type(density_type), intent(in) :: density               !! of the body
        real(dp), intent(in) :: tolerance                       !! deck units
        real(dp), intent(in) :: angle                           !! degrees
        type(run_type), allocatable, intent(out) :: runs(:)     !! the rows
        integer :: i

        allocate (runs(size(density%stretches)))
        do i = 1, size(runs)
            runs(i)%stretch = density%stretches(i)
            runs(i)%u = [0.0_dp, 1.0_dp]
            if (size(runs(i)%stretch%sections) > 0) runs(i)%u = &
                spaced(wanted(runs(i)%stretch%need, tolerance, angle))
            call set_stations(runs(i))
        end do
    end subroutine lay_rows

    !> The columns of all sections.
    pure subroutine lay_columns(density, tolerance, angle, columns)
        type(density_type), intent(in) :: density                   !! of the body
        real(dp), intent(in) :: tolerance                           !! deck units
        real(dp), intent(in) :: angle                               !! degrees
        type(column_type), allocatable, intent(out) :: columns(:)   !! of each section
        integer :: i

        allocate (columns(size(density%around)))
        do i = 1, size(columns)
            columns(i)%share = spaced(wanted(density%around(i), tolerance, angle))
        end do
    end subroutine lay_columns

    !> Rows at stations that are given, and where any line begins, joins or ends; columns as for a
    !> tolerance and an angle.
    pure subroutine station_plan(density, tolerance, angle, stations, plan)
        type(density_type), intent(in) :: density       !! of the body
        real(dp), intent(in) :: tolerance               !! deck units, above zero
        real(dp), intent(in) :: angle                   !! degrees, above zero
        real(dp), intent(in) :: stations(:)             !! deck units, in any order
        type(plan_type), intent(out) :: plan            !! the rows and columns
        integer :: i

        call lay_columns(density, tolerance, angle, plan%columns)
        allocate (plan%runs(size(density%stretches)))
        do i = 1, size(plan%runs)
            associate (run => plan%runs(i), stretch => density%stretches(i))
                run%stretch = stretch
                run%sta = in_order(stretch%from, stations, stretch%to)
                run%u = parameters_of(stretch, run%sta)
            end associate
        end do
    end subroutine station_plan

    !> The numbers between two others, with these, in order, each once.
    pure function in_order(from, numbers, to) result(sorted)
        real(dp), intent(in) :: from        !! the least
        real(dp), intent(in) :: numbers(:)  !! in any order
        real(dp), intent(in) :: to          !! the greatest
        real(dp), allocatable :: sorted(:)

        sorted = [from, rising(pack(numbers, numbers > from .and. numbers < to)), to]
    end function in_order

    !> The parameters of stations of a stretch, by halving.
    pure function parameters_of(stretch, sta) result(u)
        type(stretch_type), intent(in) :: stretch   !! any
        real(dp), intent(in) :: sta(:)              !! rising, both ends in it
        real(dp) :: u(size(sta)), low, high
        type(taylor_type) :: middle
        integer :: i, k

        u(1) = 0.0_dp
        u(size(u)) = 1.0_dp
        do i = 2, size(u) - 1
            low = 0.0_dp
            high = 1.0_dp
            do k = 1, digits(low)
                u(i) = 0.5_dp*(low + high)
                middle = station_of(stretch%span, u(i))
                if (middle%value < sta(i)) low = u(i)
                if (middle%value >= sta(i)) high = u(i)
            end do
        end do
    end function parameters_of

    !> Sets the stations of the rows of a run; its ends are those of its stretch.
    pure subroutine set_stations(run)
        type(run_type), intent(inout) :: run !! has its parameters
        type(taylor_type) :: sta
        integer :: i

        allocate (run%sta(size(run%u)))
        do i = 1, size(run%u)
            sta = station_of(run%stretch%span, run%u(i))
            run%sta(i) = sta%value
        end do
        run%sta(1) = run%stretch%from
        run%sta(size(run%sta)) = run%stretch%to
    end subroutine set_stations

    !> Steps wanted for one of the parameter, at the samples.
    pure function wanted(need, tolerance, angle) result(rate)
        type(need_type), intent(in) :: need     !! what is wanted
        real(dp), intent(in) :: tolerance       !! deck units
        real(dp), intent(in) :: angle           !! degrees
        real(dp) :: rate(size(need%chord))
        rate = max(need%chord/sqrt(0.5_dp*tolerance), need%turn*degrees/angle, &
            real(least_steps, dp))
    end function wanted

    !> Steps wanted in all.
    pure real(dp) function total(rate)
        real(dp), intent(in) :: rate(:) !! steps for one of the parameter, at the samples
        total = sum(rate)/real(size(rate), dp)
    end function total

    !> Divides 0 to 1 into steps that each take an equal part of what is wanted. Between the middles
    !> of two samples the need is that of their mean.
    pure function spaced(rate) result(at)
        real(dp), intent(in) :: rate(:) !! steps for one of the parameter, at the samples
        real(dp), allocatable :: at(:)
        real(dp) :: sum_to(0:size(rate) + 1), place(0:size(rate) + 1), goal
        integer :: i, k, n, steps

        n = size(rate)
        place = [0.0_dp, ((real(i, dp) - 0.5_dp)/real(n, dp), i=1, n), 1.0_dp]
        sum_to(0) = 0.0_dp
        do i = 1, n + 1
            sum_to(i) = sum_to(i - 1) + 0.5_dp*(rate(max(i - 1, 1)) + rate(min(i, n))) &
                *(place(i) - place(i - 1))
        end do
        steps = max(least_steps, ceiling((1.0_dp - rounding)*sum_to(n + 1)))
        allocate (at(0:steps))
        at(0) = 0.0_dp
        at(steps) = 1.0_dp
        k = 1
        do i = 1, steps - 1
            goal = sum_to(n + 1)*real(i, dp)/real(steps, dp)
            do while (sum_to(k) < goal)
                k = k + 1
            end do
            at(i) = place(k - 1) + (place(k) - place(k - 1))*(goal - sum_to(k - 1)) &
                /(sum_to(k) - sum_to(k - 1))
        end do
    end function spaced

end module export_mesh_plan
