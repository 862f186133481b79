package org.maestro.launch;

import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.io.PrintWriter;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import java.util.regex.Pattern;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.console.Console;
import org.maestro.console.questions.RefusalException;
import org.maestro.deployment.Provision;
import org.maestro.knowledge.api.Store;
import org.maestro.ontology.home.Home;
import org.maestro.platform.failover.LeaderLock;
import org.maestro.platform.hosts.HostFile;
import org.maestro.platform.hosts.HostStart;
import org.maestro.platform.jade.Premises;
import org.maestro.platform.jade.Sockets;
import org.maestro.rats.security.SiteSecurity;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** A platform that stays until it is interrupted. */
@Command(name = "run", description = "Run a platform for a home until Ctrl-C.")
final class RunCommand implements Callable<Integer> {
  private static final Pattern SLUG = Pattern.compile("[a-z0-9][a-z0-9-]{0,62}");

  /** A machine under load may still be ending the process that has died. */
  private static final Duration PORT_LET_GO_WITHIN = Duration.ofSeconds(30);

  /** Another process on this machine, of the Java and the classes of this one. */
  private static final List<String> HERE =
      List.of(
          Path.of(System.getProperty("java.home"), "bin", "java").toString(),
          "-cp",
          System.getProperty("java.class.path"),
          Maestro.class.getName(),
          "container",
          "--main={main}",
          "--name={name}",
          "--topic={topics}",
          "--provides={provides}");

  @Spec private CommandSpec spec;

  @Mixin private SimulationOptions simulation;

  @Mixin private SecurityOptions security;

  @Mixin private Allocation allocation;

  @Mixin private ConsoleOptions console;

  @Option(names = "--no-sim", description = "No simulated devices: they come over the broker.")
  private boolean withoutSimulation;

  @Option(names = "--gui", description = "Show the JADE GUI.")
  private boolean gui;

  @Option(
      names = "--broker",
      paramLabel = "URI",
      description = "An MQTT 5 broker, tcp://HOST:PORT; without: one of its own.")
  private Optional<String> broker;

  @Option(
      names = "--broker-port",
      paramLabel = "P",
      description = "Of the broker of its own, on loopback; without: a free one.")
  private Optional<Integer> brokerPort = Optional.empty();

  @Option(
      names = "--data",
      paramLabel = "DIR",
      description =
          "Keep goals, their stories, what was said and what the console showed there: after a"
              + " crash, run it again with the same DIR, and every goal goes on. Without: they end"
              + " with this process.")
  private Optional<Path> data;

  @Option(
      names = "--store",
      paramLabel = "DIR|URL",
      description =
          "Keep the RDF dataset of what is known in files there, or behind a SPARQL endpoint (URL,"
              + " or QUERY-URL,UPDATE-URL); without: in memory.")
  private Optional<String> store = Optional.empty();

  @Option(
      names = "--standby",
      description =
          "Wait beside a platform that runs with the same --data, --name and --port, and take over"
              + " as soon as its process has died.")
  private boolean standby;

  @Option(
      names = "--port",
      paramLabel = "P",
      defaultValue = "1099",
      description = "Of the JADE main container; 0: a free one; default ${DEFAULT-VALUE}.")
  private int port;

  @Option(
      names = "--host",
      paramLabel = "ADDRESS",
      description =
          "Of this machine, on which containers of other machines join; without: loopback only.")
  private Optional<String> host = Optional.empty();

  @Option(
      names = "--mtp",
      paramLabel = "[HOST:]PORT",
      description =
          "Hear agents of other platforms there, by HTTP, and let agents write to them; HOST is"
              + " loopback unless it is said. Without: no other platform is heard.")
  private Optional<String> letters = Optional.empty();

  @Option(
      names = "--provides",
      paramLabel = "WHAT",
      split = ",",
      description = "What this machine has that agents may need, such as microphone,memory=512.")
  private List<String> provides = List.of();

  @Option(
      names = "--hosts",
      paramLabel = "FILE.json",
      description =
          "Hosts that belong to the platform: their processes are started, here or by a command"
              + " such as ssh, and started again when they die.")
  private Optional<Path> hosts = Optional.empty();

  @Option(
      names = "--name",
      paramLabel = "N",
      defaultValue = "maestro",
      description = "Of the platform; default ${DEFAULT-VALUE}.")
  private String name;

  @Override
  public Integer call() throws InterruptedException {
    double speed = simulation.speed();
    check();
    RuntimeDirectory directory = RuntimeDirectory.ofUser();
    if (!standby
        && directory.running().stream().anyMatch(platform -> platform.name().equals(name))) {
      throw CommandException.outside(
          "A platform named "
              + name
              + " runs already; stop it, or choose another --name and --port.");
    }
    Home loaded = simulation.home();
    SiteSettings settings = settings(loaded, directory);
    Optional<LeaderLock> duty = data.map(this::takeDuty);
    LocalSite site = LocalSite.paced(settings, speed);
    Optional<Console> served = serve(site, settings.security());
    directory.add(
        new RuntimeDirectory.Running(
            name,
            ProcessHandle.current().pid(),
            site.platform().premises().host(),
            site.platform().port(),
            site.broker().map(URI::toString),
            settings.security().map(files -> files.directory().toString()),
            served.map(Console::uri)));
    UntilStopped.run(
        spec.commandLine().getOut(),
        announcement(loaded, site, served),
        () -> end(directory, site, served, duty));
    return ExitCode.DONE;
  }

  private SiteSettings settings(Home loaded, RuntimeDirectory directory) {
    SiteSettings.Builder wanted = SiteSettings.of(name, loaded);
    if (!withoutSimulation) {
      wanted.scene(
          simulation.scene(
              loaded,
              "A home of your own needs --scene FILE for its simulated devices, or --no-sim"
                  + " for real ones."));
    }
    wanted
        .seed(simulation.seed())
        .broker(broker.map(Endpoint::broker))
        .brokerPort(brokerPort.orElse(0))
        .jadePort(port)
        .gui(gui)
        .storyDirectory(
            data.map(kept -> directory.beginStories(kept.resolve("stories")))
                .orElseGet(() -> directory.beginStories(name)))
        .allocation(allocation.objective());
    data.ifPresent(wanted::dataDirectory);
    simulation.homeFile().ifPresent(wanted::homeFile);
    security.files().ifPresent(wanted::security);
    store.map(Store::parse).ifPresent(wanted::store);
    return wanted.premises(premises()).build();
  }

  private Optional<Console> serve(LocalSite site, Optional<SiteSecurity> files) {
    try {
      return console.start(site, name, files, data);
    } catch (RefusalException e) {
      site.close();
      throw e;
    }
  }

  private LeaderLock takeDuty(Path kept) {
    Optional<LeaderLock> now = LeaderLock.tryToTake(kept);
    if (now.isPresent()) {
      return now.get();
    }
    if (!standby) {
      throw CommandException.outside(
          "The directory %s is in use by another platform; stop it, name another directory, or wait beside it with --standby."
              .formatted(kept));
    }
    PrintWriter out = spec.commandLine().getOut();
    out.println("Standing by for the platform " + name + ". Stop with Ctrl-C.");
    LeaderLock taken = LeaderLock.await(kept);
    out.println("The platform " + name + " has died; this process takes over.");
    String address = premises().host();
    if (!Sockets.isFree(address, port)) {
      out.println("Port " + port + " is in use still; waiting for it.");
      Sockets.awaitFree(address, port, PORT_LET_GO_WITHIN);
    }
    return taken;
  }

  private Premises premises() {
    Premises usual = Premises.usual();
    return usual
        .on(host.orElse(usual.host()))
        .with(
            letters
                .map(text -> Endpoint.listening(text, usual.host()))
                .map(own -> new Premises.LetterBox(own.host(), own.port())))
        .providing(new TreeSet<>(provides))
        .starting(hosts.map(RunCommand::read).orElse(List.of()));
  }

  private static List<HostStart> read(Path file) {
    try {
      return HostFile.read(Files.readString(file), file.toString(), HERE);
    } catch (IOException e) {
      throw CommandException.badInput(
          "The file %s of hosts cannot be read; name one that is there.".formatted(file));
    } catch (IllegalArgumentException e) {
      throw CommandException.badInput(e);
    }
  }

  private void check() {
    try {
      Provision.of(provides);
    } catch (IllegalArgumentException e) {
      throw CommandException.badInput(e);
    }
    if (letters.isPresent() && security.isAsked()) {
      throw CommandException.badInput(
          "A secured site hears only whom its own processes vouch for: leave --mtp away, and have"
              + " people of other platforms join as guests (./maestro secure --guest).");
    }
    if (!SLUG.matcher(name).matches()) {
      throw CommandException.badInput(
          "\"" + name + "\" is no name for a platform; use small letters, digits and hyphens.");
    }
    requirePort("--port", port);
    console.check(security.isAsked());
    brokerPort.ifPresent(own -> requirePort("--broker-port", own));
    if (broker.isPresent() && brokerPort.isPresent()) {
      throw CommandException.badInput(
          "--broker names a broker that runs, --broker-port one of its own; leave one away.");
    }
    if (withoutSimulation && simulation.namesScene()) {
      throw CommandException.badInput("--scene and --no-sim exclude each other; leave one away.");
    }
    if (standby && (data.isEmpty() || broker.isEmpty() || !withoutSimulation || port == 0)) {
      throw CommandException.badInput(
          "--standby needs what outlives a process: --data DIR, --no-sim --broker URI, and --port P"
              + " other than 0.");
    }
    if (gui && GraphicsEnvironment.isHeadless()) {
      throw CommandException.outside(
          "There is no display for the JADE GUI; run without --gui, or set DISPLAY.");
    }
  }

  private static void requirePort(String option, int port) {
    if (port < 0 || port > 65_535) {
      throw CommandException.badInput(option + " is between 0 and 65535, not " + port + ".");
    }
  }

  private String announcement(Home loaded, LocalSite site, Optional<Console> served) {
    PrintWriter out = spec.commandLine().getOut();
    StoryPrinter printer = new StoryPrinter(out, site.clock().now());
    site.platform().onStory(printer::print);
    String runs =
        "The platform %s runs: %d agents, JADE on port %d, MQTT on %s."
            .formatted(
                name,
                site.platform().agents().size(),
                site.platform().port(),
                site.broker().map(URI::toString).orElse("no port"));
    String kept =
        data.map(directory -> "Goals and their stories are kept in " + directory + ".")
            .orElse("Goals end with this process; --data DIR keeps them over a restart.");
    String next =
        SuggestedGoal.of(loaded)
            .map(goal -> "In another terminal: ./maestro goal \"" + goal + "\"  ")
            .orElse("In another terminal, ./maestro goal --help tells how to state a goal.");
    String heard =
        site.platform()
            .premises()
            .letters()
            .map(
                box ->
                    "Agents of other platforms reach it by HTTP; there: ./maestro goal GOAL --other %s@%s"
                        .formatted(name, box.url().replaceAll("/acc$", "")))
            .map(line -> System.lineSeparator() + line)
            .orElse("");
    return String.join(System.lineSeparator(), runs, console.inWords(served), kept, next) + heard;
  }

  private void end(
      RuntimeDirectory directory,
      LocalSite site,
      Optional<Console> served,
      Optional<LeaderLock> duty) {
    directory.remove(name);
    served.ifPresent(Console::close);
    site.close();
    duty.ifPresent(LeaderLock::close);
  }
}
