!> Tests of the frame of PDF files.
program test_pdf_file
    use base_kinds, only: i64
    use base_output, only: output_type
    use base_text, only: to_text
    use export_pdf_file, only: pdf_file_type, pdf_text
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(pdf_file_type) :: file
    type(output_type) :: out
    character(:), allocatable :: text
    character(10) :: entry
    integer :: start, offset, i

    call tap%same(pdf_text('A (b) \ c'), '(A \(b\) \\ c)', &
        'parentheses and backslashes are escaped')
    call tap%same(pdf_text(char(195)//char(169)//char(208)//char(150)//char(255)//char(10)), &
        '('//char(233)//'???)', 'letters of Latin-1 are single bytes, others question marks')

    call file%begin(3, out)
    call file%object(2, '<< /Two >>', out)
    call file%stream(3, '1 2 m'//new_line('a')//'S'//new_line('a'), out)
    call file%object(1, '<< /One '//char(233)//' >>', out)
    call file%finish(1, 2, out)
    text = out%text()
    call tap%ok(index(text, '%PDF-1.4'//new_line('a')//'%') == 1, 'the file says what it is')
    call tap%has(text, '<< /Length 8 >>'//new_line('a')//'stream'//new_line('a')//'1 2 m', &
        'a stream says its length')
    start = index(text, new_line('a')//'xref') + 1
    call tap%has(text, 'startxref'//new_line('a')//to_text(int(start - 1, i64))//new_line('a')// &
        '%%EOF'//new_line('a'), 'the end says where the table is')
    call tap%has(text, '<< /Size 4 /Root 1 0 R /Info 2 0 R >>', 'the trailer how many there are')
    start = start + len('xref'//new_line('a')//'0 4'//new_line('a'))
    call tap%same(text(start:start + 19), '0000000000 65535 f '//new_line('a'), &
        'the first entry is the free one')
    do i = 1, 3
        call tap%ok(text(start + 20*i + 19:start + 20*i + 19) == new_line('a'), &
            'entries have 20 bytes')
        entry = text(start + 20*i:start + 20*i + 9)
        read (entry, *) offset
        call tap%ok(index(text(offset + 1:), to_text(i)//' 0 obj'//new_line('a')) == 1, &
            'an entry says where its object begins')
    end do
    call tap%finish()
end program test_pdf_file
