!> The work of a sweep, shared out one variant at a time to whoever is free: among the threads of
!> one process, or among processes (ranks), each of one thread. A variant depends on nothing but the
!> deck and its number, so that its row is the same whoever computes it.
module sweep_work
    use base_error, only: cause, error_type, fail
    use sweep_keeper, only: keeper_type
    use sweep_ranks, only: has_row, send_number, send_row, take_number, take_row, team_type
    use sweep_record, only: read_row, record_type, row_of_record
    use sweep_study, only: study_type
    use sweep_variant, only: compute_variant
    implicit none (type, external)
    private

    public :: lead_work, follow_work

    !> Variants a rank has at a time: one in hand, one that waits for it while rank 0 is busy.
    integer, parameter :: in_hand = 2

contains

    !> Computes variants, on rank 0 or alone.
    !>
    !> Fails with what the keeper fails with; what it has kept stays.
    subroutine lead_work(study, team, pending, keeper, error)
        type(study_type), intent(in) :: study               !! the sweep
        type(team_type), intent(in) :: team                 !! the processes
        integer, intent(in) :: pending(:)                   !! numbers of the variants to compute
        class(keeper_type), intent(inout) :: keeper         !! gets them as they are finished
        type(error_type), allocatable, intent(out) :: error !! see above

        if (team%count > 1) then
            call lead_ranks(study, team, pending, keeper, error)
        else
            call lead_threads(study, pending, keeper, error)
        end if
    end subroutine lead_work

    !> Shares variants out among the threads of this process.
    subroutine lead_threads(study, pending, keeper, error)
        type(study_type), intent(in) :: study               !! the sweep
        integer, intent(in) :: pending(:)                   !! variants to compute
        class(keeper_type), intent(inout) :: keeper         !! gets them
        type(error_type), allocatable, intent(out) :: error !! from the keeper
        logical :: is_broken
        integer :: i

        is_broken = .false.
        !$omp parallel do schedule(dynamic, 1) default(shared)
        do i = 1, size(pending)
            call compute_and_keep(study, pending(i), keeper, is_broken, error)
        end do
        !$omp end parallel do
    end subroutine lead_threads

    !> Computes a variant and hands it to the keeper, one thread at a time. After an error nothing
    !> more is done.
    subroutine compute_and_keep(study, number, keeper, is_broken, error)
        type(study_type), intent(in) :: study                   !! the sweep
        integer, intent(in) :: number                           !! the variant
        class(keeper_type), intent(inout) :: keeper             !! gets it
        logical, intent(inout) :: is_broken                     !! there was an error
        type(error_type), allocatable, intent(inout) :: error   !! from the keeper
        type(record_type) :: record
        logical :: is_over

        !$omp atomic read
        is_over = is_broken
        if (is_over) return
        call compute_variant(study, number, record)
        !$omp critical (keeping)
        if (.not. allocated(error)) call keeper%keep(record, error)
        if (allocated(error)) then
            !$omp atomic write
            is_broken = .true.
        end if
        !$omp end critical (keeping)
    end subroutine compute_and_keep

    !> Shares variants out among the ranks. Rank 0 computes as well, and between two variants of its
    !> own takes the rows that have come and sends their senders more.
    subroutine lead_ranks(study, team, pending, keeper, error)
        type(study_type), intent(in) :: study               !! the sweep
        type(team_type), intent(in) :: team                 !! the processes
        integer, intent(in) :: pending(:)                   !! variants to compute
        class(keeper_type), intent(inout) :: keeper         !! gets them
        type(error_type), allocatable, intent(out) :: error !! from the keeper
        type(record_type) :: record
        integer :: given, away, rank, i

        given = 0
        away = 0
        do i = 1, in_hand
            do rank = 1, team%count - 1
                call hand_out(pending, rank, given, away)
            end do
        end do
        do while (given < size(pending) .or. away > 0)
            if (given == size(pending) .or. has_row()) then
                if (away == 0) exit
                call receive(study, record, rank, error)
                away = away - 1
            else
                given = given + 1
                rank = 0
                call compute_variant(study, pending(given), record)
            end if
            if (.not. allocated(error)) call keeper%keep(record, error)
            if (allocated(error)) exit
            if (rank > 0) call hand_out(pending, rank, given, away)
        end do
        call dismiss(team, away)
    end subroutine lead_ranks

    !> Sends a rank the next variant, if there is one.
    subroutine hand_out(pending, rank, given, away)
        integer, intent(in) :: pending(:)   !! variants to compute
        integer, intent(in) :: rank         !! who gets one
        integer, intent(inout) :: given     !! how many of them are given out
        integer, intent(inout) :: away      !! how many are not back yet
        if (given == size(pending)) return
        given = given + 1
        away = away + 1
        call send_number(rank, pending(given))
    end subroutine hand_out

    !> Takes a row that another rank has sent.
    !>
    !> Fails with `cause%file_trouble` where it is none, which is a fault of the network.
    subroutine receive(study, record, rank, error)
        type(study_type), intent(in) :: study               !! the sweep
        type(record_type), intent(out) :: record            !! the variant
        integer, intent(out) :: rank                        !! who sent it
        type(error_type), allocatable, intent(out) :: error !! see above
        character(:), allocatable :: row
        logical :: is_sound

        call take_row(row, rank)
        call read_row(row, study, record, is_sound)
        if (.not. is_sound) call fail(error, cause%file_trouble, &
            'a row that another rank sent can''t be read: '//row)
    end subroutine receive

    !> Takes the rows that are still to come, kept or not, and lets the ranks go.
    subroutine dismiss(team, away)
        type(team_type), intent(in) :: team !! the processes
        integer, intent(in) :: away         !! variants that are not back yet
        character(:), allocatable :: row
        integer :: i, rank

        do i = 1, away
            call take_row(row, rank)
        end do
        do rank = 1, team%count - 1
            call send_number(rank, 0)
        end do
    end subroutine dismiss

    !> Computes what rank 0 hands out, on any other rank.
    subroutine follow_work(study)
        type(study_type), intent(in) :: study !! the sweep
        type(record_type) :: record
        integer :: number

        do
            call take_number(number)
            if (number == 0) return
            call compute_variant(study, number, record)
            call send_row(row_of_record(record, .false.))
        end do
    end subroutine follow_work

end module sweep_work
