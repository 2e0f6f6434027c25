!> The measures that a sweep looks at, of one body: each a number, or the words why there is none.
module sweep_measure
    use base_decimal, only: to_real
    use base_kinds, only: dp
    use base_text, only: compact
    use body_body, only: body_type
    use body_ledger, only: is_broken, joint_type
    use cut_clearance, only: clearance_type
    use cut_measure, only: measure_section, section_measure_type
    use cut_measure_body, only: body_measure_type, measure_whole
    use cut_offsets, only: half_breadths, heights, offset_table_type
    use deck_sweep, only: measure, wanted_type
    implicit none (type, external)
    private

    public :: measured_type, value_type, measure_of, needs_measures

    !> A body and what is known of it.
    type :: measured_type
        type(body_type) :: body                             !! finished
        type(joint_type), allocatable :: joints(:)          !! of its lines
        type(clearance_type), allocatable :: clearances(:)  !! of its components
        type(body_measure_type) :: whole                    !! where it is asked for
        logical :: has_whole = .false.                      !! it was measured
    end type measured_type

    !> A measure.
    type :: value_type
        real(dp) :: number = 0.0_dp             !! its value, 0 where there is none
        character(:), allocatable :: why        !! why there is none; not set: there is one
    end type value_type

contains

    !> True where a measure is one of the whole body, for which it is integrated.
    elemental logical function needs_measures(kind)
        integer, intent(in) :: kind !! one of `measure%...`
        needs_measures = kind >= measure%volume .and. kind <= measure%centroid
    end function needs_measures

    !> Takes a measure.
    pure subroutine measure_of(measured, wanted, value)
        type(measured_type), intent(inout) :: measured  !! the body; keeps what was integrated
        type(wanted_type), intent(in) :: wanted         !! which measure
        type(value_type), intent(out) :: value          !! its value

        if (needs_measures(wanted%measure) .and. .not. measured%has_whole) then
            call measure_whole(measured%body, measured%whole)
            measured%has_whole = .true.
        end if
        select case (wanted%measure)
        case (measure%volume, measure%wetted, measure%centroid)
            call take_whole(measured%whole, wanted%measure, value)
        case (measure%area, measure%girth)
            call measure_at(measured%body, to_real(wanted%sta), wanted%measure, value)
        case (measure%width, measure%height)
            call measure_across(measured%body, wanted, value)
        case (measure%clear)
            call measure_clearance(measured%clearances, wanted%of, value)
        case (measure%jump, measure%break)
            call measure_joints(measured%joints, wanted, value)
        end select
        if (allocated(value%why)) return
        if (.not. abs(value%number) <= huge(1.0_dp)) value%why = 'it is no finite number'
        if (allocated(value%why)) value%number = 0.0_dp
    end subroutine measure_of

    !> Volume, wetted area, station of the centroid.
    pure subroutine take_whole(whole, kind, value)
        type(body_measure_type), intent(in) :: whole    !! of the body
        integer, intent(in) :: kind                     !! which of them
        type(value_type), intent(inout) :: value        !! gets it

        if (kind == measure%wetted) then
            value%number = whole%wetted_area
            if (.not. whole%has_wetted) value%why = whole%why
        else
            value%number = merge(whole%volume, whole%centroid(1), kind == measure%volume)
            if (.not. whole%has_volume) value%why = whole%why
        end if
    end subroutine take_whole

    !> Area or girth of the section at a station.
    pure subroutine measure_at(body, sta, kind, value)
        type(body_type), intent(in) :: body         !! the body
        real(dp), intent(in) :: sta                 !! station, deck units
        integer, intent(in) :: kind                 !! which of them
        type(value_type), intent(inout) :: value    !! gets it
        type(section_measure_type) :: section

        call measure_section(body, sta, section)
        if (kind == measure%area) then
            value%number = section%area
            if (.not. section%has_area) value%why = section%why
        else
            value%number = section%girth
            if (.not. section%has_girth) value%why = section%why
        end if
    end subroutine measure_at

    !> Breadth of the section at a station on a waterline, or its height on a butt line: from the
    !> outermost point of the skin there to the opposite one.
    pure subroutine measure_across(body, wanted, value)
        type(body_type), intent(in) :: body         !! the body
        type(wanted_type), intent(in) :: wanted     !! station, and waterline or butt line
        type(value_type), intent(inout) :: value    !! gets it
        type(offset_table_type) :: table
        real(dp), allocatable :: met(:)
        integer :: i
        logical :: is_width

        is_width = wanted%measure == measure%width
        if (is_width) then
            table = half_breadths(body, [to_real(wanted%at)], [to_real(wanted%sta)])
        else
            table = heights(body, [to_real(wanted%at)], [to_real(wanted%sta)])
        end if
        allocate (met(0))
        do i = 1, size(table%rows)
            met = [met, table%rows(i)%figure(1)]
            if (is_width .and. body%is_symmetric) met = [met, -table%rows(i)%figure(1)]
        end do
        if (size(met) > 1) then
            value%number = maxval(met) - minval(met)
        else
            value%why = 'the section at station '//compact(to_real(wanted%sta))// &
                trim(merge(' does not meet   ', ' meets only once ', size(met) == 0))// &
                trim(merge(' waterline', ' butt line', is_width))//' '//compact(to_real(wanted%at))
        end if
    end subroutine measure_across

    !> The least clearance of the components, or of those of a name.
    pure subroutine measure_clearance(clearances, name, value)
        type(clearance_type), intent(in) :: clearances(:)   !! of the body
        character(*), intent(in) :: name                    !! of a component; blank: of all
        type(value_type), intent(inout) :: value            !! gets it
        integer :: i

        value%why = 'no CHECK card asks for a clearance'
        do i = 1, size(clearances)
            if (name /= '' .and. clearances(i)%name /= name) cycle
            if (.not. clearances(i)%has_gap) then
                value%why = clearances(i)%note
                return
            end if
            if (allocated(value%why)) value%number = clearances(i)%gap
            value%number = min(value%number, clearances(i)%gap)
            if (allocated(value%why)) deallocate (value%why)
        end do
    end subroutine measure_clearance

    !> The greatest jump of curvature, or break of slope, at the joints of lines where no knuckle
    !> is meant; 0 where there is no joint.
    pure subroutine measure_joints(joints, wanted, value)
        type(joint_type), intent(in) :: joints(:)   !! of the lines
        type(wanted_type), intent(in) :: wanted     !! jump or break, of a line or all
        type(value_type), intent(inout) :: value    !! gets it
        real(dp) :: size_here
        integer :: i

        do i = 1, size(joints)
            if (wanted%of /= '' .and. joints(i)%line /= wanted%of) cycle
            if (joints(i)%is_knuckle) cycle
            size_here = abs(joints(i)%jump%curvature)
            if (wanted%measure == measure%break) &
                size_here = merge(abs(joints(i)%jump%direction), 0.0_dp, is_broken(joints(i)))
            value%number = max(value%number, size_here)
        end do
    end subroutine measure_joints

end module sweep_measure
