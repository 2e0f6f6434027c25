!> The processes that share a sweep. This is the program that runs alone: one process, whose rank is
!> 0, with nobody to write to. `mpi/sweep/ranks.f90` is the same module over MPI; which of the two
!> is linked is the Makefile's choice (`make MPI=1`).
!>
!> Rank 0 has the deck, the files and the terminal. It gives the others the text of the deck, then
!> numbers of variants, and gets rows back; the number 0 ends it.
module sweep_ranks
    implicit none (type, external)
    private

    public :: team_type, join_team, leave_team, share_text
    public :: send_number, take_number, send_row, take_row, has_row

    !> The processes.
    type :: team_type
        integer :: rank = 0     !! which of them this is, from 0
        integer :: count = 1    !! how many there are
    end type team_type

contains

    !> Joins the other processes; to be called once, first.
    subroutine join_team(team)
        type(team_type), intent(out) :: team !! the processes
        team%count = 1
    end subroutine join_team

    !> Leaves them; to be called once, last. Nobody goes before all are through.
    subroutine leave_team()
    end subroutine leave_team

    !> Gives the text that rank 0 has to all others, which wait for it.
    subroutine share_text(text)
        character(:), allocatable, intent(inout) :: text !! of rank 0; of others it is replaced
        if (.not. allocated(text)) text = ''
    end subroutine share_text

    !> Rank 0 sends a number to another rank; here there is none.
    subroutine send_number(rank, number)
        integer, intent(in) :: rank     !! to which
        integer, intent(in) :: number   !! a variant, or 0
        if (rank == number) return
    end subroutine send_number

    !> Another rank waits for the next number of rank 0.
    subroutine take_number(number)
        integer, intent(out) :: number !! a variant, or 0
        number = 0
    end subroutine take_number

    !> Another rank sends a row to rank 0; here there is none.
    subroutine send_row(row)
        character(*), intent(in) :: row !! of a finished variant
        if (row == '') return
    end subroutine send_row

    !> Rank 0 waits for the next row of any other rank.
    subroutine take_row(row, rank)
        character(:), allocatable, intent(out) :: row   !! of a finished variant
        integer, intent(out) :: rank                    !! who sent it
        row = ''
        rank = 0
    end subroutine take_row

    !> Rank 0 asks, without waiting, whether a row has come.
    logical function has_row()
        has_row = .false.
    end function has_row

end module sweep_ranks
