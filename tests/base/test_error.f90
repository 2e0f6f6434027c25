!> Errors as values.
program test_error
    use base_error, only: cause, cause_list, error_type, fail
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(error_type), allocatable :: error
    integer, parameter :: words = storage_size(cause)/storage_size(0)
    integer :: number(words), i

    call tap%ok(.not. allocated(error), 'nothing has failed before it is tried')
    call fail(error, cause%inflection, 'two words')
    call tap%ok(allocated(error), 'a failure is allocated')
    call tap%ok(error%cause == cause%inflection, 'it knows its cause')
    call tap%same(error%message, 'two words', 'it has its words, no blank more')
    call fail(error, cause%usage, '')
    call tap%ok(error%cause == cause%usage .and. len(error%message) == 0, &
        'a second failure takes the place of the first')

    number = transfer(cause_list(), number)
    call tap%ok(all([(count(number == number(i)) == 1, i = 1, words)]), &
        'no two causes share a number')
    call tap%ok(all(number > 0), 'no cause has the number of no cause')
    call tap%finish()
end program test_error
