!> What is asked where nothing is said, and that the numbers of kinds are those of the cards.
program test_request
    use base_kinds, only: dp
    use cut_plane, only: cut_kind
    use cut_request, only: cut_rule, request_type
    use deck_job, only: cut, rule
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(request_type) :: request

    call tap%ok(request%rule == cut_rule%number .and. request%number == 25, &
        '25 points where nothing is said')
    call tap%ok(.not. any(request%limit%has_from .or. request%limit%has_to), 'no limits')
    call tap%ok(.not. abs(request%skin) > 0.0_dp, 'and no skin')
    call tap%ok(all([cut_rule%step, cut_rule%number, cut_rule%length, cut_rule%chord] == &
        [rule%step, rule%number, rule%length, rule%chord]), 'rules are numbered as on the cards')
    call tap%ok(all([cut_kind%station, cut_kind%buttock, cut_kind%waterline, cut_kind%oblique, &
        cut_kind%plane] == [cut%station, cut%buttock, cut%waterline, cut%oblique, cut%plane]), &
        'and so are kinds of cuts')
    call tap%finish()
end program test_request
