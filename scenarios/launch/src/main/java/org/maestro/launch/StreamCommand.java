package org.maestro.launch;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.maestro.assembly.StreamAnalyst;
import org.maestro.assembly.StreamMember;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.stream.Recording;
import org.maestro.rats.stream.RecordingException;
import org.maestro.rats.stream.RecordingWriter;
import org.maestro.rats.stream.StreamReceiver;
import org.maestro.rats.time.PacedClock;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** The pictures or the sound of a member, received, recorded, analysed and played again. */
@Command(
    name = "stream",
    description =
        "Have a camera or a microphone stream, tell how late what it streams arrives, and record it"
            + " or have it analysed; or play a recording to whoever asks for it. It ends after"
            + " --for, at the stream's end, or by Ctrl-C.")
final class StreamCommand implements Callable<Integer> {
  private static final String USUAL_USER = "screen";
  private static final String USUAL_FEATURE = "streamPictures";
  private static final double NANOS = 1e9;
  private static final double LONGEST_SECONDS = 7 * 24 * 3600;

  @Spec private CommandSpec spec;
  @Mixin private SiteOptions options;

  @Parameters(
      paramLabel = "MEMBER",
      arity = "0..1",
      description = "Whose pictures or sound; not with --replay.")
  private Optional<String> member = Optional.empty();

  @Option(
      names = "--feature",
      paramLabel = "NAME",
      description =
          "Which feature of it streams, such as streamSound, or replay of a recording; without:"
              + " streamPictures.")
  private Optional<String> feature = Optional.empty();

  @Option(
      names = "--with",
      paramLabel = "NAME=NUMBER",
      description =
          "A parameter of the feature, such as frequency=5 or tone=440; may be given several"
              + " times.")
  private Map<String, Double> parameters = new LinkedHashMap<>();

  @Option(
      names = "--for",
      paramLabel = "SECONDS",
      description = "How long; without: until it ends, or Ctrl-C.")
  private Optional<Double> seconds = Optional.empty();

  @Option(
      names = "--to",
      paramLabel = "FILE",
      description = "Record it in a file that is not there yet.")
  private Optional<Path> file = Optional.empty();

  @Option(
      names = "--analyse-as",
      paramLabel = "ID",
      description =
          "Join as a member of that name, and tell by it how bright pictures are and how much in"
              + " them moves, or how strong and high sound is.")
  private Optional<String> analyst = Optional.empty();

  @Option(
      names = "--user",
      paramLabel = "ID",
      description =
          "As which controller to ask; of a secured site one that it has. Without: screen, on open"
              + " sites with the number of this process.")
  private Optional<String> user = Optional.empty();

  @Option(
      names = "--replay",
      paramLabel = "FILE",
      description = "Play what was recorded with --to, as a member, to whoever asks for it.")
  private Optional<Path> recorded = Optional.empty();

  @Option(names = "--as", paramLabel = "ID", description = "As which member to play it.")
  private Optional<String> player = Optional.empty();

  @Override
  public Integer call() throws InterruptedException {
    requireSense();
    try {
      if (recorded.isPresent()) {
        replay(recorded.get(), player.orElseThrow());
      } else {
        receive(member.orElseThrow());
      }
    } catch (RecordingException failure) {
      throw CommandException.outside(
          Optional.ofNullable(failure.getMessage()).orElse(failure.toString()), failure);
    }
    return ExitCode.DONE;
  }

  private void requireSense() {
    if (recorded.isPresent() == member.isPresent()) {
      throw CommandException.badInput(
          "Name either the MEMBER whose stream is wanted, or a recording with --replay FILE --as"
              + " ID.");
    }
    if (recorded.isPresent() != player.isPresent()) {
      throw CommandException.badInput(
          "--replay FILE and --as ID belong together: a recording is played as a member.");
    }
    if (seconds.filter(time -> !(time > 0 && time <= LONGEST_SECONDS)).isPresent()) {
      throw CommandException.badInput(
          "--for takes seconds above 0, a week at most, and not %s.".formatted(seconds.get()));
    }
  }

  private void replay(Path from, String id) throws InterruptedException {
    Recording recording = Recording.read(from);
    SiteOptions.Found site = options.join(id);
    try (PacedClock clock = new PacedClock(1);
        RatsMember playing =
            StreamMember.replaying(
                recording,
                id,
                site.bus().policy(),
                site.bus().transports().apply(id),
                site.name(),
                clock)) {
      UntilStopped.run(
          spec.commandLine().getOut(),
          "The recording %s (%d frames) is %s on %s."
              .formatted(from, recording.frames().size(), id, site.broker()),
          playing::close);
    }
  }

  private void receive(String from) throws InterruptedException {
    SiteOptions.Found site = options.find();
    String receiver =
        user.orElse(
            site.isSecured() ? USUAL_USER : USUAL_USER + "-" + ProcessHandle.current().pid());
    site.bus().requireLetIn(receiver);
    analyst.ifPresent(site.bus()::requireLetIn);
    PrintWriter out = spec.commandLine().getOut();
    StreamReceiver.Wanted wanted =
        new StreamReceiver.Wanted(
            from, feature.orElse(USUAL_FEATURE), new LinkedHashMap<>(parameters));
    Optional<RecordingWriter> recording = file.map(RecordingWriter::create);
    try (PacedClock clock = new PacedClock(1)) {
      Optional<StreamAnalyst> analysing =
          analyst.map(
              id ->
                  StreamAnalyst.start(
                      id,
                      site.bus().policy(),
                      site.bus().transports().apply(id),
                      site.name(),
                      clock));
      StreamReception reception =
          new StreamReception(
              wanted,
              recording,
              received -> analysing.ifPresent(one -> one.add(received.frame())),
              out);
      StreamReceiver opened =
          StreamReceiver.open(
              wanted,
              receiver,
              site.name(),
              site.bus().transports().apply(receiver),
              clock,
              site.bus().kind(),
              reception);
      try {
        reception.take(opened, seconds.map(StreamCommand::duration));
      } finally {
        analysing.ifPresent(StreamAnalyst::close);
      }
    } finally {
      recording.ifPresent(RecordingWriter::close);
    }
  }

  private static Duration duration(double seconds) {
    return Duration.ofNanos(Math.round(seconds * NANOS));
  }
}
