!> Times in words. What is written on a terminal is tested by tests/export.t and tests/sweep.t.
program test_progress
    use app_progress, only: time_words
    use base_kinds, only: i64
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call tap%same(time_words(0_i64), '0 s', 'nothing')
    call tap%same(time_words(59_i64), '59 s', 'seconds')
    call tap%same(time_words(60_i64), '1 min 0 s', 'a minute')
    call tap%same(time_words(3599_i64), '59 min 59 s', 'minutes')
    call tap%same(time_words(3600_i64), '1 h 0 min', 'an hour')
    call tap%same(time_words(359999_i64), '99 h 59 min', 'hours')
    call tap%finish()
end program test_progress
