# Measures the points of the sweep: errors and memory from one dump, times
# from runs in turn. What was measured is kept by what it depends on, so that
# a run that was broken off goes on, and an unchanged one is not repeated.
package Measure;

use strict;
use warnings;

use Digest::SHA  qw(sha1_hex);
use Exporter     qw(import);
use File::Path   qw(make_path remove_tree);
use File::Temp   qw(tempdir);
use JSON::PP     ();
use MIME::Base64 qw(encode_base64);
use VSM;
use Progress;
use Workers qw(share_out);

our @EXPORT_OK = qw(measure processors table quantile times_of summarise);

my $JSON = JSON::PP->new->canonical;
my $work = tempdir( CLEANUP => 1 );    # for what nobody is to see

# The lines of a CSV table as hashes.
sub table {
    my ( $head, @lines ) = split /\n/, shift // '';
    my @names = split /,/, $head // '';
    my @rows;
    for my $line (@lines) {
        my %row;
        @row{@names} = split /,/, $line;
        push @rows, \%row;
    }
    return @rows;
}

sub quantile {
    my ( $part, @samples ) = @_;
    @samples = sort { $a <=> $b } @samples;
    my $place = $part * $#samples;
    my $index = int $place;
    my $next  = $index < $#samples ? $index + 1 : $index;
    return $samples[$index] +
      ( $place - $index ) * ( $samples[$next] - $samples[$index] );
}

# --- what is kept ------------------------------------------------------------

# The contents of every file that a result depends on: a step's program, the
# shaders, the oracle. Programs are linked with the shaders' place in the tree.
my %contents;

sub content {
    my @paths = @_;
    return join ' ', map {
        $contents{$_} //= -e $_ ? Digest::SHA->new->addfile($_)->hexdigest : ''
    } @paths;
}

sub shaders {
    my @folders = ( root(), $ENV{VSM_SHADERS} // () );
    my @files = ( 'shaders/*', 'techniques/*/*', 'base/*/shaders/*' );
    return content(
        sort map {
            my $folder = $_;
            map { matching( $folder, "step*/$_" ) } @files
        } @folders
    );
}

# The processors by their names; one without a name where that is not known.
sub processors {
    my $cpu   = -e '/proc/cpuinfo' ? slurp('/proc/cpuinfo') : '';
    my @names = $cpu =~ /^model name\s*:\s*(.*)$/mg;
    @names = ('') x $1 if !@names && command('nproc')->{out} =~ /^(\d+)/;
    return @names ? @names : ('');
}

# The files in which a point's results are kept.
sub places {
    my ( $point, $folder, $frames ) = @_;
    my @drawn = (
        content( program( $point->{step} ) ),
        shaders(), @{ $point->{options} }
    );
    my @judged =
      ( content( oracle_path() ), oracle_words($point), $point->{pictured} );
    return (
        "$folder/kept/errors." . sha1_hex( join "\0", @drawn, @judged ),
        "$folder/kept/times."
          . sha1_hex( join "\0", @drawn, processors(), $frames )
    );
}

sub kept {
    my ($path) = @_;
    return unless -e "$path.json";
    return eval { $JSON->decode( slurp("$path.json") ) };
}

# A file is there whole or not at all.
sub keep {
    my ( $path, $what ) = @_;
    return
      if eval { spew( "$path.partial", $JSON->encode($what) ) || 1 }
      && rename "$path.partial", "$path.json";
    my $why = $@ || "cannot write $path.json: $!\n";
    unlink "$path.partial";
    die "measured, but not kept: $why";
}

# --- errors and memory -------------------------------------------------------

sub oracle_path { return ( program(1) =~ s{[^/]+$}{}r ) . 'oracle' }

sub oracle_words {
    my ($point) = @_;
    my @words = ( "rays=$point->{rays}", 'chain=1', 'lower=0' );
    push @words, "light-size=$point->{light_size}" if $point->{light_size};
    return @words;
}

# A command's output; dies with its last line when it fails.
sub answer {
    my ($run) = @_;
    return $run->{out} if $run->{status} == 0 && $run->{signal} == 0;
    my ($line) = $run->{err} =~ /([^\n]+)\n*\z/;
    my $how =
      $run->{signal}
      ? "killed by signal $run->{signal}"
      : "exit status $run->{status}";
    die "$how: " . ( $line // 'no word why' ) . "\n";
}

sub errors_of {
    my ( $point, $truths, $dump ) = @_;
    remove_tree($dump);
    make_path($dump);
    answer(
        run(
            $point->{step}, @{ $point->{options} },
            '--dump',       $dump,
            '--output',     "$dump/picture.png"
        )
    );
    my @rows = table(
        answer(
            command(
                oracle_path(),  'errors',
                $dump,          oracle_words($point),
                "keep=$truths", "pictures=$dump"
            )
        )
    );
    my $run   = $JSON->decode( slurp("$dump/run.json") );
    my %found = (
        truths => { map { delete $_->{truth} => $_ } @rows },
        map { $_ => $run->{$_} } qw(map_bytes gl_renderer gl_version),
    );
    my $seen = butteraugli($dump);
    $found{butteraugli} = $seen           if defined $seen;
    $found{pictures}    = pictures($dump) if $point->{pictured};
    return \%found;
}

# Truths are kept for one build of the oracle; older ones are of no use.
sub truths_folder {
    my ($folder) = @_;
    my $own = "$folder/kept/truths." . substr content( oracle_path() ), 0, 16;
    return $own if -d $own;
    remove_tree( matching( $folder, 'kept/truths.*' ) );
    make_path($own);
    return $own;
}

# How much of the difference is seen, by the measure that JPEG XL is tuned
# with: the 3-norm over the picture of distances in just noticeable steps.
# Nothing where it is not installed.
my $BUTTERAUGLI = '/usr/bin/butteraugli_main';

sub butteraugli {
    my ($dump) = @_;
    return unless -x $BUTTERAUGLI;
    my $run = command( $BUTTERAUGLI, map { "$dump/$_.png" } qw(truth result) );
    return $run->{out} =~ /^3-norm: ([\d.]+)$/m ? $1 + 0 : undef;
}

sub pictures {
    my ($dump) = @_;
    return { map { $_ => encode_base64( slurp("$dump/$_.png"), '' ) }
          qw(truth result difference) };
}

# --- times -------------------------------------------------------------------

# One run: {clock, passes => {name => [milliseconds of each frame]}}. The map is
# drawn in every frame, as where something moves, or of an `unchanged` scene
# only once, before.
sub times_of {
    my ( $point, $frames ) = @_;
    my $picture = "$work/bench.png";
    my @rows    = table(
        answer(
            run(
                $point->{step},
                @{ $point->{options} },
                $point->{unchanged} ? () : '--redraw',
                '--bench', $frames, '--output', $picture
            )
        )
    );
    @rows or die "the program printed no times\n";
    return {
        clock  => $rows[0]{clock},
        passes => {
            map {
                $_->{pass} => [ map { $_ + 0 } split / /, $_->{samples_ms} ]
            } @rows
        },
    };
}

# The first pass fills the map, whatever its name in that step.
my %PASS = ( depth => 'map', moments => 'map' );

sub summarise {
    my ( $point, @rounds ) = @_;
    my %samples;
    for my $round (@rounds) {
        for my $pass ( keys %{ $round->{passes} } ) {
            my $times = $round->{passes}{$pass};
            push @{ $samples{ $PASS{$pass} // $pass } }, @$times;
            push @{ $point->{medians}{ $PASS{$pass} // $pass } },
              quantile( 0.5, @$times );
            push @{ $point->{fastest}{ $PASS{$pass} // $pass } },
              quantile( 0, @$times );
        }
        $point->{clock} = $round->{clock};
    }
    for my $pass ( keys %samples ) {
        my @times = @{ $samples{$pass} };
        $point->{"${pass}_ms"} = quantile( 0.5,  @times );
        $point->{"${pass}_q1"} = quantile( 0.25, @times );
        $point->{"${pass}_q3"} = quantile( 0.75, @times );
    }
    $point->{frames} = @{ $samples{total} // [] };
    $point->{rounds} = @rounds;
    return;
}

# --- all of it ---------------------------------------------------------------

# Runs the work; what it dies of becomes the point's, and the report goes on.
sub attempt {
    my ( $point, $work ) = @_;
    my $value = eval { $work->() };
    return $value if defined $value;
    $point->{missing} //= $@ =~ s/\n\z//r;
    return;
}

# Errors, then times, of every point; into the points. `stopped` is a
# reference to a flag that ends the measuring early. Returns how many results
# were there already.
sub measure {
    my ( $points, $mode, $folder, $stopped ) = @_;
    make_path("$folder/kept");
    my ( @unknown, @turns, $reused );
    for my $point (@$points) {
        my ( $errors, $times ) = places( $point, $folder, $mode->{frames} );
        $point->{kept_errors} = $errors;
        $point->{kept_times}  = $times;
        $point->{found}       = kept($errors);
        $point->{timed}       = ( kept($times) // {} )->{rounds} // [];
        push @unknown, $point unless $point->{found};
        my $there = @{ $point->{timed} };
        $reused++ if $point->{found} && $there >= $mode->{rounds};
        push @{ $turns[$_] }, $point for $there .. $mode->{rounds} - 1;
    }
    my $progress = Progress->new(
        errors => scalar @unknown,
        times  => scalar map { @{ $_ // [] } } @turns,
    );
    measure_errors( \@unknown, $folder, $progress, $stopped );
    for my $point ( map { @{ $_ // [] } } @turns ) {
        last if $$stopped;
        measure_times( $point, $mode, $progress, $stopped );
    }
    $progress->finish;
    finish($_) for @$points;
    return $reused // 0;
}

# Several points at a time: errors do not depend on how long they take.
sub measure_errors {
    my ( $points, $folder, $progress, $stopped ) = @_;
    my $truths = truths_folder($folder);    # once, for all at a time
    my $judge  = sub {
        my ( $point, $slot ) = @_;
        return errors_of( $point, $truths, "$work/dump.$slot" );
    };
    my $take = sub {
        my ( $point, $found, $why ) = @_;
        $progress->done( 'errors', "$point->{scene} $point->{label}" );
        $point->{missing} = $why if !$found;
        return                   if !$found;
        $point->{found} = $found;
        attempt( $point, sub { keep( $point->{kept_errors}, $found ); 1 } );
    };
    $progress->begin('errors');
    my @processors = processors();
    share_out( scalar @processors, $points, $judge, $take, $stopped );
    return;
}

sub measure_times {
    my ( $point, $mode, $progress, $stopped ) = @_;
    $progress->begin('times');
    my $times;
    $times =
      attempt( $point, sub { times_of( $point, $mode->{frames} ) } )
      unless $point->{missing};    # it would fail once more
    $progress->done( 'times', "$point->{scene} $point->{label}" );
    if ($$stopped) { delete $point->{missing}; return }
    $times or return;
    push @{ $point->{timed} }, $times;
    attempt( $point,
        sub { keep( $point->{kept_times}, { rounds => $point->{timed} } ); 1 }
    );
    return;
}

# What was found, as the point's columns.
sub finish {
    my ($point) = @_;
    my $found   = delete $point->{found};
    my @timed   = @{ delete $point->{timed} };
    if ($found) {
        my %truths = %{ $found->{truths} };
        $truths{light} = $point->{soft} ? $truths{area} : $truths{hard};
        for my $truth ( keys %truths ) {
            my $columns = $truths{$truth};
            $point->{ $truth =~ s/\./_/r . "_$_" } = $columns->{$_}
              for keys %$columns;
        }
        $point->{$_} = $found->{$_}
          for qw(map_bytes gl_renderer gl_version butteraugli pictures);
    }
    summarise( $point, @timed ) if @timed;
    $point->{missing} //=
      ( $found ? 'no times' : 'not measured' ) . ': it was broken off'
      if !$found || !@timed;
    return;
}

1;
