# Chromium without a window, driven through chromedriver's HTTP (WebDriver).
# Core modules only. Nothing is asked of a network.
package Browser;

use strict;
use warnings;

use File::Temp ();
use HTTP::Tiny;
use IO::Socket::INET;
use JSON::PP     ();
use MIME::Base64 qw(decode_base64);
use POSIX        ();
use Time::HiRes  qw(sleep);
use VSM          qw(spew);

my ( $CHROMIUM, $DRIVER ) = qw(/usr/bin/chromium /usr/bin/chromedriver);
my $JSON = JSON::PP->new->ascii->allow_nonref;

# Why there is no browser; '' where there is one.
sub lacking {
    my @missing = grep { !-x $_ } $CHROMIUM, $DRIVER;
    return @missing ? "no @missing here" : '';
}

sub free_port {
    my $socket = IO::Socket::INET->new(
        LocalAddr => '127.0.0.1',
        Listen    => 1
    ) or die "no port: $!\n";
    return $socket->sockport;
}

# A browser with a page of this size; dies with a line that says why not.
sub new {
    my ( $class, $width, $height ) = @_;
    my $port   = free_port();
    my $folder = File::Temp->newdir;
    my $child  = fork // die "cannot fork: $!\n";
    if ( $child == 0 ) {
        setpgrp;
        open STDIN,  '<', '/dev/null';
        open STDOUT, '>', '/dev/null';
        open STDERR, '>', '/dev/null';
        exec {$DRIVER} $DRIVER, "--port=$port" or POSIX::_exit(127);
    }
    my $self = bless {
        child  => $child,
        owner  => $$,
        folder => $folder,
        http   => HTTP::Tiny->new( timeout => 300, proxy => undef ),
        url    => "http://127.0.0.1:$port",
    }, $class;
    $self->wait_for_driver;
    my $session = $self->ask(
        POST => '/session',
        {
            capabilities => {
                alwaysMatch => {
                    browserName          => 'chrome',
                    'goog:loggingPrefs'  => { browser => 'ALL' },
                    'goog:chromeOptions' => {
                        binary => $CHROMIUM,
                        args   => [
                            qw(--headless --no-sandbox --disable-gpu
                              --no-first-run --disable-sync
                              --disable-background-networking
                              --disable-component-update
                              --disable-dev-shm-usage),
                            "--user-data-dir=$folder"
                        ],
                    },
                }
            }
        }
    );
    $self->{session} = "/session/$session->{sessionId}";
    $self->resize( $width, $height );
    return $self;
}

sub wait_for_driver {
    my ($self) = @_;
    for ( 1 .. 1200 ) {
        return if $self->{http}->get("$self->{url}/status")->{success};
        sleep 0.1;
    }
    die "chromedriver does not answer\n";
}

sub ask {
    my ( $self, $method, $path, $body ) = @_;
    my $answer = $self->{http}->request(
        $method,
        $self->{url} . $path,
        {
            headers => { 'content-type' => 'application/json' },
            $body ? ( content => $JSON->encode($body) ) : ()
        }
    );
    my $value = eval { $JSON->decode( $answer->{content} )->{value} };
    die "$path: $answer->{status} "
      . ( ref $value eq 'HASH' ? $value->{message} : $answer->{content} ) . "\n"
      unless $answer->{success};
    return $value;
}

sub cdp {
    my ( $self, $command, $parameters ) = @_;
    return $self->ask(
        POST => "$self->{session}/goog/cdp/execute",
        { cmd => $command, params => $parameters }
    );
}

# The page's own size, whatever a window may be; that of a phone too.
sub resize {
    my ( $self, $width, $height ) = @_;
    $self->cdp(
        'Emulation.setDeviceMetricsOverride',
        {
            width             => $width + 0,
            height            => $height + 0,
            deviceScaleFactor => 1,
            mobile            => $width < 600 ? JSON::PP::true : JSON::PP::false
        }
    );
    return;
}

# light or dark
sub prefer {
    my ( $self, $scheme ) = @_;
    $self->cdp(
        'Emulation.setEmulatedMedia',
        {
            features => [ { name => 'prefers-color-scheme', value => $scheme } ]
        }
    );
    return;
}

sub open_file {
    my ( $self, $path ) = @_;
    my $url = 'file://' . $path =~ s{([^\w./-])}{sprintf '%%%02X', ord $1}gear;
    $self->ask( POST => "$self->{session}/url", { url => $url } );
    return;
}

# What the page's own JavaScript returns.
sub js {
    my ( $self, $script, @arguments ) = @_;
    return $self->ask(
        POST => "$self->{session}/execute/sync",
        { script => $script, args => \@arguments }
    );
}

# Clicks on the element's middle, as a finger would.
sub click {
    my ( $self, $css ) = @_;
    my $found = $self->ask(
        POST => "$self->{session}/element",
        { using => 'css selector', value => $css }
    );
    my ($id) = values %$found;
    $self->ask( POST => "$self->{session}/element/$id/click", {} );
    return $id;
}

# Types into an element; the arrow keys are named by their WebDriver codes.
sub type {
    my ( $self, $css, $text ) = @_;
    my $found = $self->ask(
        POST => "$self->{session}/element",
        { using => 'css selector', value => $css }
    );
    my ($id) = values %$found;
    $self->ask(
        POST => "$self->{session}/element/$id/value",
        { text => $text }
    );
    return;
}

# The lines of the page's console since the last call.
sub console {
    my ($self) = @_;
    my $lines =
      $self->ask( POST => "$self->{session}/se/log", { type => 'browser' } );
    return map { "$_->{level} $_->{message}" } @$lines;
}

# A picture of what is in sight, or of the whole page.
sub screenshot {
    my ( $self, $path, $whole ) = @_;
    my $shot = $self->cdp(
        'Page.captureScreenshot',
        {
            format                => 'png',
            captureBeyondViewport => $whole ? JSON::PP::true : JSON::PP::false
        }
    );
    spew( $path, decode_base64( $shot->{data} ) );
    return;
}

sub DESTROY {
    my ($self) = @_;
    return if $$ != $self->{owner};
    local ( $@, $?, $! );
    eval { $self->ask( DELETE => $self->{session} ) } if $self->{session};
    kill 'TERM', $self->{child};
    waitpid $self->{child}, 0;
    return;
}

1;
