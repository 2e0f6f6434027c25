!> A body: control lines and the sections that they carry.
module body_body
    use base_kinds, only: dp
    use base_order, only: rising
    use body_line, only: line_type
    use body_section, only: limit_section, section_joints, section_type, trace_at, trace_type
    use deck_job, only: name_length
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: body_type, finish_body, mirrored_body, is_image, smooth_stops

    !> A body, in deck units.
    type :: body_type
        character(name_length) :: name = ''             !! its name, or blank
        type(line_type), allocatable :: lines(:)        !! its control lines
        type(section_type), allocatable :: sections(:)  !! its sections
        logical :: is_symmetric = .true.                !! sections are the starboard half
        logical :: is_closed = .false.                  !! sections are closed along BL 0
        logical :: has_nose = .false.                   !! the nose is rounded
        real(dp) :: nose_radius = 0.0_dp                !! its radius
    end type body_type

contains

    !> What follows from the lines and sections of a body: draws the sections in to where their
    !> lines are, and finds which side of each is the outside.
    pure subroutine finish_body(body)
        type(body_type), intent(inout) :: body !! lines and sections are set
        integer :: i
        do i = 1, size(body%sections)
            call limit_section(body%lines, body%sections(i))
        end do
        call find_outside(body)
    end subroutine finish_body

    !> Sections that meet on a line of the same side are run through in one sense. The outside is to
    !> the right where a run, as seen from BL 0 at the mean WL of its ends, sweeps an area
    !> counter-clockwise (WL over BL), else to the left.
    pure subroutine find_outside(body)
        type(body_type), intent(inout) :: body !! sections have their ranges
        integer :: run(size(body%sections)), i
        real(dp) :: sense(size(body%sections))

        call find_runs(body%sections, run, sense)
        do i = 1, maxval([0, run])
            if (swept_area(body, run == i, sense) < 0.0_dp) where (run == i) sense = -sense
        end do
        body%sections%outward = sense
    end subroutine find_outside

    !> Numbers the runs of sections that meet, and gives each section a sense in its run.
    pure subroutine find_runs(sections, run, sense)
        type(section_type), intent(in) :: sections(:)   !! of a body
        integer, intent(out) :: run(:)                  !! number of the run of each
        real(dp), intent(out) :: sense(:)               !! 1: as the run goes, -1: against it
        integer :: i, j, known

        run = 0
        sense = 1.0_dp
        do i = 1, size(sections)
            if (run(i) > 0) cycle
            run(i) = maxval(run) + 1
            known = 0
            do while (count(run > 0) > known)
                known = count(run > 0)
                do j = 1, size(sections)
                    if (run(j) == 0) call join(sections, j, run, sense)
                end do
            end do
        end do
    end subroutine find_runs

    !> Takes a section into the run of one that it meets.
    pure subroutine join(sections, new, run, sense)
        type(section_type), intent(in) :: sections(:)   !! of a body
        integer, intent(in) :: new                      !! a section of no run yet
        integer, intent(inout) :: run(:)                !! number of the run of each, or 0
        real(dp), intent(inout) :: sense(:)             !! 1: as the run goes, -1: against it
        integer :: old

        do old = 1, size(sections)
            if (run(old) == 0 .or. .not. meets(sections(old), sections(new))) cycle
            run(new) = run(old)
            sense(new) = sense(old)
            if (is_turned(sections(old), sections(new))) sense(new) = -sense(old)
            return
        end do
    end subroutine join

    !> True where two sections have an end line and a side in common, and a range where both are.
    pure logical function meets(first, second)
        type(section_type), intent(in) :: first     !! a section
        type(section_type), intent(in) :: second    !! another
        meets = (first%is_port .eqv. second%is_port) &
            .and. max(first%from, second%from) < min(first%to, second%to) &
            .and. (any(first%line(1) == second%line([1, 3])) &
            .or. any(first%line(3) == second%line([1, 3])))
    end function meets

    !> True where two sections that meet both start, or both finish, on their common line.
    pure logical function is_turned(first, second)
        type(section_type), intent(in) :: first     !! a section
        type(section_type), intent(in) :: second    !! another
        is_turned = .not. (first%line(1) == second%line(3) .or. first%line(3) == second%line(1))
    end function is_turned

    !> Twice the area that some sections sweep about BL 0 at the mean WL of their ends, each at the
    !> middle of its range.
    pure real(dp) function swept_area(body, chosen, sense) result(area)
        type(body_type), intent(in) :: body     !! a body
        logical, intent(in) :: chosen(:)        !! the sections to take
        real(dp), intent(in) :: sense(:)        !! 1 or -1: which way each is run through
        type(trace_type) :: trace(size(chosen))
        real(dp) :: centre(2)
        integer :: i

        centre = 0.0_dp
        do i = 1, size(chosen)
            if (.not. chosen(i)) cycle
            associate (section => body%sections(i))
                trace(i) = trace_at(body%lines, section, 0.5_dp*(section%from + section%to))
            end associate
            centre(2) = centre(2) + trace(i)%start%point(2) + trace(i)%finish%point(2)
        end do
        centre(2) = 0.5_dp*centre(2)/real(max(1, count(chosen)), dp)
        area = 0.0_dp
        do i = 1, size(chosen)
            if (.not. chosen(i)) cycle
            area = area + sense(i)*( &
                cross(trace(i)%start%point - centre, trace(i)%shoulder - centre) &
                + cross(trace(i)%shoulder - centre, trace(i)%finish%point - centre))
        end do
    end function swept_area

    !> A symmetric body with its port half: the mirror images of all sections stand behind them, in
    !> the same order. Another body is as it was.
    pure type(body_type) function mirrored_body(body) result(whole)
        type(body_type), intent(in) :: body !! finished
        integer :: count
        whole = body
        if (.not. body%is_symmetric) return
        count = size(body%sections)
        whole%sections = [body%sections, body%sections]
        whole%sections(count + 1:)%is_port = .not. body%sections%is_port
        whole%sections(count + 1:)%outward = -body%sections%outward
        whole%is_symmetric = .false.
    end function mirrored_body

    !> True for the port half of a section of BOTH sides: its original stands right before it.
    pure logical function is_image(body, number)
        type(body_type), intent(in) :: body !! any
        integer, intent(in) :: number       !! which of its sections
        is_image = body%sections(number)%is_port
        if (number == 1) is_image = .false.
        if (is_image) is_image = .not. body%sections(number - 1)%is_port .and. &
            body%sections(number - 1)%name == body%sections(number)%name
    end function is_image

    !> The stations between which the lines of a section are smooth: its range and the joints
    !> inside, in order, each once.
    pure function smooth_stops(body, section) result(stops)
        type(body_type), intent(in) :: body         !! finished
        type(section_type), intent(in) :: section   !! one of its sections
        real(dp), allocatable :: stops(:)
        stops = [section%from, rising(section_joints(body%lines, section)), section%to]
    end function smooth_stops

end module body_body
