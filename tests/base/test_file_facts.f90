!> What the system says of files.
program test_file_facts
    use, intrinsic :: iso_c_binding, only: c_int
    use base_file_facts, only: facts_of_file, file_facts_type
    use base_posix, only: c_getpid
    use base_text, only: to_text
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(file_facts_type) :: facts
    character(:), allocatable :: folder

    folder = '/tmp/loft-test-facts-'//to_text(int(c_getpid()))
    call execute_command_line('mkdir '//folder//' && cd '//folder//' && printf 12345 > file'// &
        ' && chmod 640 file && printf 1 > "blank " && chmod 751 "blank " && ln -s file link &&'// &
        ' mkfifo fifo && ln -s nowhere dangling')
    facts = facts_of_file(folder//'/file')
    call tap%ok(facts%exists .and. facts%is_regular .and. .not. facts%is_folder, 'a regular file')
    call tap%ok(facts%permissions == int(o'640', c_int), 'its permissions')
    call tap%ok(facts%length == 5, 'its length')
    facts = facts_of_file(folder//'/link')
    call tap%ok(facts%is_regular .and. facts%length == 5, 'of a link what it leads to')
    facts = facts_of_file(folder//'/blank ')
    call tap%ok(facts%permissions == int(o'751', c_int), 'a blank at the end belongs to the name')
    facts = facts_of_file(folder//'/blank')
    call tap%ok(.not. facts%exists, 'without it there is no such file')
    facts = facts_of_file(folder)
    call tap%ok(facts%exists .and. facts%is_folder .and. .not. facts%is_regular, 'a folder')
    facts = facts_of_file(folder//'/fifo')
    call tap%ok(facts%exists .and. .not. facts%is_regular .and. .not. facts%is_folder, 'a FIFO')
    facts = facts_of_file('/dev/null')
    call tap%ok(facts%exists .and. .not. facts%is_regular, 'a device')
    facts = facts_of_file(folder//'/dangling')
    call tap%ok(.not. facts%exists, 'a link that leads nowhere')
    facts = facts_of_file(folder//'/none')
    call tap%ok(.not. facts%exists .and. facts%length == 0, 'no file')
    call execute_command_line('rm -r '//folder)
    call tap%finish()
end program test_file_facts
