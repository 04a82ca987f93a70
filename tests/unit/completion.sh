#!/usr/bin/env bash
# What is typed completes in bash, zsh and fish from an installed tree: commands, options, models, parameters, states,
# coordinates, words and files. Every option that --help lists is offered, and the words offered for --method are all taken.
# Shells other than bash are tried where they are installed.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cmake --install "$JLT_BINARY_DIR" --prefix "$scratch/tree" > "$scratch/log" || { cat "$scratch/log"; exit 1; }
export PATH=$scratch/tree/bin:$PATH HOME=$scratch
share=$scratch/tree/share
mkdir "$scratch/here" "$scratch/here/folder"
cd "$scratch/here"
printf 'param k > 0\nstate x\nstate v\n' > own.tt
touch motion.scene table.csv
status=0
fail() { echo "$*"; status=1; }

# Each prints what the shell would put in place of the last word of $1, a line each. Readline puts it behind the last = of that.
bash_says() {
    local last=${1##* }
    bash --norc -c 'source "$0"; COMP_LINE=$1 COMP_POINT=${#1}; _jellett; printf -- "$2%s\n" "${COMPREPLY[@]}"' \
        "$share/bash-completion/completions/${1%% *}" "$1" "${last%"${last##*=}"}"
}
# What compadd and _files are given: the rest of zsh's completion wants a terminal.
zsh_says() {
    zsh -f -c 'compadd() { print -l -- ${(P)@[-1]} }
               compset() { IPREFIX=${PREFIX%%\=*}= PREFIX=${PREFIX#*=} }
               _files() { local -a all; all=($PREFIX*(/N)); [[ $1 = -/ ]] || all+=($PREFIX${~2}(N))
                          (( ! $#all )) || print -l -- $IPREFIX${^all} }
               words=("${(z)1}"); [[ $1 != *" " ]] || words+=(""); CURRENT=$#words PREFIX=$words[-1] IPREFIX=
               source $0' "$share/zsh/site-functions/_jellett" "$1"
}
fish_says() {
    fish -c 'source $argv[1]; complete -C $argv[2]' "$share/fish/vendor_completions.d/${1%% *}.fish" "$1" |
        cut -f 1 | sed 's|/$||'
}

expect() { # LINE, and all that may stand in place of its last word
    local shell said wanted
    wanted=$(printf '%s\n' "${@:2}" | sort -u)
    for shell in "${shells[@]}"; do
        said=$("${shell}_says" "$1" | sort -u)
        [ "$said" = "$wanted" ] || fail "$shell: '$1' completes to ${said//$'\n'/ }"
    done
}

shells=(bash)
for shell in zsh fish; do
    if command -v $shell > /dev/null; then shells+=("$shell"); else echo "skipped: $shell is not installed"; fi
done

expect 'jellett sec' section
expect 'jellett -' --help --version
expect 'jellett help sec' section
expect 'ttc help pr' prove
expect 'ttc ' check prove show generate build cost discover
expect 'ttc prove --ch' --challenge
expect 'ttc show --format ' text latex dot
expect 'ttc generate --effort=' --effort={quick,full}
expect 'ttc generate --out ' folder
expect 'ttc check own.tt ' own.tt folder
expect 'jellett simulate lor' lorenz
expect 'jellett simulate o' own.tt
expect 'jellett simulate lorenz --set ' sigma= rho= beta=
expect 'jellett simulate lorenz --set=sigma=9,b' --set=sigma=9,beta=
expect 'jellett simulate lorenz -a x=1,' x=1,y= x=1,z=
expect 'jellett simulate own.tt --start ' x= v=
expect 'jellett simulate --set m=2 --tier qua' quadrature
expect 'jellett section --start ' eta= gamma3=
expect 'jellett section lorenz --section z=27 --start ' x= y=
expect 'jellett section --section turning --start ' eta= gamma3=
expect 'jellett section --section ' turning gamma3= v_nu= omega_tau= omega_n= omega3=
expect 'jellett section --direction ' up down both
expect 'jellett section --contact=' --contact={ignore,report,end}
expect 'jellett section --level ' E= G=
expect 'jellett portrait --level ' E= G= F0=
expect 'jellett fates --sweep=a' --sweep=a3=
expect 'jellett rod --sweep omega' omega_tau= omega_n= omega3=
expect 'jellett section --grid ' eta= gamma3=
expect 'jellett section --grid 24' ''
expect 'jellett simulate --method rk' rk8pd rkf45
expect 'jellett orbits --hold eta,' eta,gamma3
expect 'jellett section --style=grey,' --style=grey,{dots,nokey,points=,lines=}
expect 'jellett section --style l' lines=
expect 'jellett simulate lorenz --axes ' t x y z
expect 'jellett section lorenz --section z=27 --axes x,' x,y
expect 'jellett plan section --dir' --direction
expect 'jellett run ' motion.scene folder
expect 'jellett run --into ' folder
expect 'jellett section --plot t' table.csv
expect 'jellett section --plot=' --plot={own.tt,table.csv,motion.scene,folder}
expect 'jellett nothing ' ''
# Other operands than models; what is proved stands before the model.
expect 'jellett certify s' sink symmetric
expect 'jellett certify sink lor' lorenz
expect 'jellett certify sink lorenz --set ' sigma= rho= beta=
expect 'jellett sweep ' motion.scene folder
expect 'jellett merge t' table.csv
expect 'jellett check ' folder
expect 'jellett bench s' section slope
# What has no description is shown as it is.
if [[ " ${shells[*]} " = *" zsh "* ]]; then
    zsh -f -c 'compadd() { print -l -- $shown } ; words=(jellett simulate --method rk) CURRENT=4 PREFIX=rk; source $0' \
        "$share/zsh/site-functions/_jellett" > shown
    diff shown <(printf '%s\n' rk8pd rkf45) || fail "zsh shows methods with dashes behind them"
fi

for program in jellett ttc; do
    mapfile -t commands < <(bash_says "$program ")
    [ ${#commands[@]} -ge 6 ] || fail "$program: only ${#commands[@]} commands are offered"
    for command in "${commands[@]}"; do
        listed=$("$program" "$command" --help | grep -oE '^(  -., |      )--[a-z-]+' | sed 's/.* //' | sort)
        offered=$(bash_says "$program $command -" | sort)
        [ "$offered" = "$listed" ] || fail "$program $command --help lists other options than are offered: ${offered//$'\n'/ }"
    done
done
for method in $(bash_says 'jellett simulate --method '); do
    jellett simulate lorenz --start x=1,y=1,z=1 --times 0 --method "$method" > /dev/null || fail "--method $method is offered"
done
exit $status
