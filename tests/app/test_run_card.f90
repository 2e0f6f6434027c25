!> One card computed: its text, and what is wrong with it.
program test_run_card
    use app_options, only: options_type
    use app_run_card, only: card_result_type, compute_card
    use base_kinds, only: i64
    use deck_conic_deck, only: card_image_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(options_type) :: options
    type(card_image_type) :: image
    type(card_result_type) :: it

    image%label = ''
    image%count = 7
    image%line%text = '0.      0.      .5      4.      2.      8.      4.      .5      8.'
    image%line%length = len(image%line%text, i64)
    image%line%filled = len(image%line%text)
    image%line%number = 9
    options%arithmetic = 'ieee'
    options%format = 'csv'
    call compute_card(options, image, it)
    call tap%same(it%text%text(), '7,X,0,0,0.5,0'//new_line('a')//'7,X,8,4,0.5,0'//new_line('a'), &
        'the rows of a line as CSV')
    call tap%ok(it%faults%count == 0 .and. it%count == 7, 'nothing is wrong with it')
    image%line%text(1:1) = 'O'
    call compute_card(options, image, it)
    call tap%same(it%text%text(), '', 'a letter leaves no row')
    call tap%ok(it%faults%has_errors(0), 'but a fault')
    call tap%ok(it%faults%item(1)%line == 9, 'with its line')
    call tap%finish()

end program test_run_card
