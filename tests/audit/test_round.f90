!> Round numbers between two values.
program test_round
    use audit_figure, only: figure_length
    use audit_round, only: numbers_between, round_numbers
    use base_kinds, only: dp
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    character(figure_length), allocatable :: texts(:)

    allocate (texts(0))
    texts = round_numbers(0.052251_dp, 0.052349_dp)
    call tap%ok(size(texts) == 1, 'one number of four decimals is between .052251 and .052349')
    call tap%same(trim(texts(1)), '0.0523', 'it is .0523')
    texts = round_numbers(-0.0699_dp, -0.0695_dp)
    call tap%ok(size(texts) == 5, 'five between -.0699 and -.0695, ends included')
    call tap%same(trim(texts(5)), '-0.0695', 'in order')
    texts = round_numbers(-0.4_dp, 0.3_dp)
    call tap%same(trim(texts(1)), '0', 'zero is the roundest')
    texts = round_numbers(9.0_dp, 9.0_dp)
    call tap%same(trim(texts(1)), '9', 'a number is between itself and itself')
    texts = round_numbers(1.0_dp/3.0_dp, 1.0_dp/3.0_dp)
    call tap%ok(size(texts) <= 1, 'a third has none of few decimals')
    texts = numbers_between(0.4035_dp, 0.4045_dp, 4)
    call tap%ok(size(texts) == 11, 'eleven numbers of four decimals are .404 to three')
    texts = numbers_between(0.0_dp, 1.0_dp, 3)
    call tap%ok(size(texts) == 0, 'too many are not listed')
    texts = numbers_between(0.11_dp, 0.19_dp, 1)
    call tap%ok(size(texts) == 0, 'nor is any where there is none')
    call tap%finish()
end program test_round
