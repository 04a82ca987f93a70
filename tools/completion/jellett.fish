# Completion of jellett and ttc in fish: what share/jellett/complete says beside the program that is typed.
function __jellett_complete
    set -l words (commandline -opc)
    set -l current (commandline -ct)
    set -l program (realpath (command -s $words[1]))
    set -l option (string match -r '^--[a-z-]+=' -- "$current")
    set -l typed (string replace -r '^--[a-z-]+=' '' -- "$current")
    for line in (bash (dirname $program)/../share/jellett/complete $program $words[2..-1] "$current")
        set -l names
        switch $line
            case '@folders*'
                set names $typed*/
            case '@files *.*'
                set names $typed*(string replace '@files *' '' -- $line) $typed*/
            case '@files*'
                set names (path filter -f -- $typed*) $typed*/
            case '*'
                echo $line
        end
        for name in $names
            printf '%s\n' "$option$name"
        end
    end
end
for program in jellett ttc
    complete -c $program -f -a '(__jellett_complete)'
end
