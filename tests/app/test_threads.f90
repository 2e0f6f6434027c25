!> What the environment may ask of stacks; `limits.t` runs LOFT with small ones and many threads.
program test_threads
    use app_threads, only: bytes_asked, prepare_threads
    use base_error, only: error_type
    use base_kinds, only: i64
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(error_type), allocatable :: error

    call asks('512', 524288_i64, 'a number is of KiB')
    call asks(' 64 k ', 65536_i64, 'a letter may be small, blanks may stand around it')
    call asks('3B', 3_i64, 'bytes')
    call asks('2M', 2097152_i64, 'MiB')
    call asks('4G', 4294967296_i64, 'GiB')
    call asks('0', 0_i64, 'nothing at all')
    call asks('', huge(1_i64), 'no words leave it to the system')
    call asks('many', huge(1_i64), 'so do words that are no number')
    call asks('-5k', huge(1_i64), 'and a number below zero')
    call asks('k', huge(1_i64), 'and a letter alone')
    call tap%ok(bytes_asked('99999999999999999999999G') > 2_i64**60, &
        'a number beyond all bounds is large')
    call prepare_threads(error)
    call tap%ok(.not. allocated(error), 'the stack of this test is large enough')
    call tap%finish()

contains

    !> Checks the bytes that some words ask for.
    subroutine asks(words, bytes, name)
        character(*), intent(in) :: words   !! of the environment
        integer(i64), intent(in) :: bytes   !! what they mean
        character(*), intent(in) :: name    !! of the check
        call tap%ok(bytes_asked(words) == bytes, name)
    end subroutine asks

end program test_threads
