!> Names that are taken, and what others are called then.
program test_taken_names
    use base_text, only: to_text
    use export_taken_names, only: new_taken, take_name, taken_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(taken_type) :: taken
    character(:), allocatable :: name
    logical :: is_right
    integer :: i

    taken = new_taken(7)
    call tap%same(taken_as('FRAME'), 'FRAME', 'a new name stays')
    call tap%same(taken_as('frame'), 'frame-2', 'other letters are the same name')
    call tap%same(taken_as('FRAME-2'), 'FRAME-2-2', 'a suffix that is there is a name like others')
    call tap%same(taken_as('FRAME-4'), 'FRAME-4', 'one that is not, too')
    call tap%same(taken_as('FRAME'), 'FRAME-3', 'suffixes go on')
    call tap%same(taken_as('FRAME'), 'FRAME-5', 'and pass over what is taken')
    call tap%same(taken_as(''), '', 'no letters are a name')

    taken = new_taken(100000)
    is_right = .true.
    do i = 1, 50000
        is_right = is_right .and. taken_as('A'//to_text(i)) == 'A'//to_text(i)
    end do
    call tap%ok(is_right, '50000 names stay as they are')
    is_right = taken_as('B') == 'B'
    do i = 2, 50000
        is_right = is_right .and. taken_as('b') == 'b-'//to_text(i)
    end do
    call tap%ok(is_right, 'one asked for 50000 times is counted up')
    call tap%finish()

contains

    !> What a name is called.
    function taken_as(asked) result(given)
        character(*), intent(in) :: asked
        character(:), allocatable :: given
        name = asked
        call take_name(taken, name)
        given = name
    end function taken_as

end program test_taken_names
