!> The processes that share a sweep, over MPI: the twin of `src/sweep/ranks.f90`, with the same
!> interface. Nothing else of LOFT knows MPI.
!>
!> Rank 0 has the deck, the files and the terminal. It gives the others the text of the deck, then
!> numbers of variants, and gets rows back; the number 0 ends it. Where MPI fails it ends all
!> processes, as is its custom; the rows that were kept stay.
module sweep_ranks
    use mpi_f08, only: mpi_any_source, mpi_bcast, mpi_character, mpi_comm_rank, mpi_comm_size, &
        mpi_comm_world, mpi_finalize, mpi_get_count, mpi_init, mpi_integer, mpi_iprobe, &
        mpi_probe, mpi_recv, mpi_send, mpi_status, mpi_status_ignore
    implicit none (type, external)
    private

    public :: team_type, join_team, leave_team, share_text
    public :: send_number, take_number, send_row, take_row, has_row

    !> The processes.
    type :: team_type
        integer :: rank = 0     !! which of them this is, from 0
        integer :: count = 1    !! how many there are
    end type team_type

    !> What a message is.
    integer, parameter :: number_tag = 1, row_tag = 2

contains

    !> Joins the other processes; to be called once, first.
    subroutine join_team(team)
        type(team_type), intent(out) :: team !! the processes
        call mpi_init()
        call mpi_comm_rank(mpi_comm_world, team%rank)
        call mpi_comm_size(mpi_comm_world, team%count)
    end subroutine join_team

    !> Leaves them; to be called once, last. Nobody goes before all are through.
    subroutine leave_team()
        call mpi_finalize()
    end subroutine leave_team

    !> Gives the text that rank 0 has to all others, which wait for it.
    subroutine share_text(text)
        character(:), allocatable, intent(inout) :: text !! of rank 0; of others it is replaced
        integer :: length

        if (.not. allocated(text)) text = ''
        length = len(text)
        call mpi_bcast(length, 1, mpi_integer, 0, mpi_comm_world)
        if (length /= len(text)) then
            deallocate (text)
            allocate (character(length) :: text)
        end if
        call mpi_bcast(text, length, mpi_character, 0, mpi_comm_world)
    end subroutine share_text

    !> Rank 0 sends a number to another rank.
    subroutine send_number(rank, number)
        integer, intent(in) :: rank     !! to which
        integer, intent(in) :: number   !! a variant, or 0
        call mpi_send(number, 1, mpi_integer, rank, number_tag, mpi_comm_world)
    end subroutine send_number

    !> Another rank waits for the next number of rank 0.
    subroutine take_number(number)
        integer, intent(out) :: number !! a variant, or 0
        call mpi_recv(number, 1, mpi_integer, 0, number_tag, mpi_comm_world, mpi_status_ignore)
    end subroutine take_number

    !> Another rank sends a row to rank 0.
    subroutine send_row(row)
        character(*), intent(in) :: row !! of a finished variant
        call mpi_send(row, len(row), mpi_character, 0, row_tag, mpi_comm_world)
    end subroutine send_row

    !> Rank 0 waits for the next row of any other rank.
    subroutine take_row(row, rank)
        character(:), allocatable, intent(out) :: row   !! of a finished variant
        integer, intent(out) :: rank                    !! who sent it
        type(mpi_status) :: status
        integer :: length

        call mpi_probe(mpi_any_source, row_tag, mpi_comm_world, status)
        call mpi_get_count(status, mpi_character, length)
        rank = status%mpi_source
        allocate (character(length) :: row)
        call mpi_recv(row, length, mpi_character, rank, row_tag, mpi_comm_world, &
            mpi_status_ignore)
    end subroutine take_row

    !> Rank 0 asks, without waiting, whether a row has come.
    logical function has_row()
        call mpi_iprobe(mpi_any_source, row_tag, mpi_comm_world, has_row, mpi_status_ignore)
    end function has_row

end module sweep_ranks
