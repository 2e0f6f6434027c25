!> Tests of networks.
program test_network
    use base_kinds, only: dp
    use export_network, only: networks_type, note_networks, scale_networks
    use export_receipt, only: receipt_type
    use support_nets, only: two_nets
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(networks_type) :: networks
    type(receipt_type) :: receipt, other

    networks = two_nets()
    call note_networks(networks, 'OBJECT', receipt)
    call tap%ok(receipt%count == 2, 'an entity for each network')
    call tap%same(receipt%entities(1)%name//'|'//receipt%entities(1)%kind, 'UPPER|OBJECT', &
        'its name and kind')
    call tap%ok(receipt%entities(1)%points == 6 .and. receipt%entities(1)%spans == 2, &
        'its points and the spans between contours')
    call tap%near(receipt%entities(1)%error + receipt%entities(1)%worst(2), 2.5_dp, 0.0_dp, &
        'its error and where')
    call tap%has(receipt%notes, 'chosen for the tolerance', 'where contours are')
    call tap%has(receipt%notes, 'flat panels', 'and what is approximate')
    networks%is_by_deck = .true.
    call note_networks(networks, 'OBJECT', other)
    call tap%has(other%notes, 'that the deck cuts', 'contours may be asked for')
    call scale_networks(networks, 0.1_dp, 'CM')
    call tap%same(networks%units, 'CM', 'scaled networks have the new unit')
    call tap%near(networks%list(1)%points(1, 2, 3) + networks%list(2)%points(3, 1, 1), 2.25_dp, &
        1.0e-15_dp, 'their points are scaled')
    call tap%near(networks%list(1)%error + networks%list(1)%worst(3), 0.35_dp, 1.0e-15_dp, &
        'and their errors')
    call tap%finish()
end program test_network
