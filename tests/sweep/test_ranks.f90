!> A program that runs alone is rank 0 of one; tests/mpi.t runs several.
program test_ranks
    use support_tap, only: tap_type
    use sweep_ranks, only: has_row, join_team, leave_team, send_number, send_row, share_text, &
        take_number, take_row, team_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(team_type) :: team
    character(:), allocatable :: text, row
    integer :: number, rank

    call join_team(team)
    call tap%ok(team%rank == 0 .and. team%count == 1, 'alone')
    text = 'a deck'
    call share_text(text)
    call tap%same(text, 'a deck', 'a text that is shared stays')
    deallocate (text)
    call share_text(text)
    call tap%same(text, '', 'none becomes an empty one')
    call send_number(0, 1)
    call take_number(number)
    call tap%ok(number == 0, 'there is nobody to be told anything')
    call send_row('a row')
    call tap%ok(.not. has_row(), 'and nobody who sends rows')
    call take_row(row, rank)
    call tap%ok(row == '' .and. rank == 0, 'none comes')
    call leave_team()
    call tap%finish()
end program test_ranks
