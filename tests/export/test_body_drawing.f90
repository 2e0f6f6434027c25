!> Tests of drawings: layers, words and the room they take. Oracles are counts by hand.
program test_body_drawing
    use base_kinds, only: dp
    use base_text, only: to_text
    use export_body_drawing, only: drawing_type, mark_of, word_side
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(drawing_type) :: drawing
    real(dp), parameter :: line(2, 2) = reshape([0.0_dp, 0.0_dp, 1.0_dp, 2.0_dp], [2, 2])
    integer :: i

    do i = 1, 20
        call drawing%draw('section', line*real(i, dp))
    end do
    call drawing%draw('grid', line)
    call drawing%draw('section', -line)
    call tap%ok(drawing%layers == 2, 'lines of a style share a layer')
    call tap%ok(drawing%layer(1)%count == 21, 'a layer takes any number of lines')
    call tap%near(drawing%layer(1)%stroke(20)%at(2, 2), 40.0_dp, 0.0_dp, 'lines stay in order')
    call tap%near(drawing%layer(1)%stroke(21)%at(1, 2), -1.0_dp, 0.0_dp, 'the last line is last')
    call drawing%draw('nothing', line(:, :0))
    call tap%ok(drawing%layers == 2, 'a line without points is none')
    do i = 1, 20
        call drawing%draw('skin', line, patch=i)
    end do
    call tap%ok(drawing%layers == 22, 'patches are layers of their own')

    do i = 1, 40
        call drawing%write_words('word '//to_text(i), [0.0_dp, 100.0_dp*real(i, dp)], &
            word_side%middle, 0)
    end do
    call tap%ok(drawing%count == 40, 'any number of words')
    call tap%same(drawing%words(40)%text, 'word 40', 'words stay in order')

    call drawing%write_where_free('here', reshape([0.0_dp, 105.0_dp, 0.0_dp, 150.0_dp], [2, 2]), &
        word_side%middle)
    call tap%near(drawing%words(41)%at(2), 150.0_dp, 0.0_dp, &
        'words go to the first place where they hide none')
    call drawing%write_where_free('nowhere', reshape([0.0_dp, 105.0_dp], [2, 1]), word_side%middle)
    call tap%ok(drawing%count == 41, 'and nowhere where all places are taken')
    call drawing%write_where_free('left', reshape([-40.0_dp, 100.0_dp], [2, 1]), word_side%left)
    call tap%ok(drawing%count == 42, 'words that end left of others hide none')
    call drawing%write_where_free('left', reshape([-10.0_dp, 100.0_dp], [2, 1]), word_side%left)
    call tap%ok(drawing%count == 42, 'words that end on others do')

    call tap%same(mark_of(7.0_dp), '7', 'a whole number has no point')
    call tap%same(mark_of(-4.5_dp), '-4.5', 'a decimal has one')
    call tap%same(mark_of(100.0_dp), '100', 'zeros before the point stay')
    call tap%finish()
end program test_body_drawing
