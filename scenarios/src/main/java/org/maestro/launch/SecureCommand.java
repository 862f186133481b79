package org.maestro.launch;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import org.maestro.rats.security.SecureSite;
import org.maestro.rats.security.SiteUsers;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Makes the files of a secured site, or adds users to them. */
@Command(
    name = "secure",
    description =
        "Make a secured site's certificates, users, rules and broker files; again: add users.")
final class SecureCommand implements Callable<Integer> {
  private static final List<String> LOCAL_HOSTS = List.of("localhost", "127.0.0.1");
  private static final List<String> USUAL_CONTROLLERS =
      List.of(
          "maestro",
          "container-robots",
          "container-cameras",
          "container-lights",
          "container-sensors");

  @Spec private CommandSpec spec;

  @Parameters(index = "0", paramLabel = "DIR", description = "Where the files are, or are to be.")
  private Path directory;

  @Parameters(
      index = "1",
      arity = "0..1",
      paramLabel = "HOME.ttl",
      description =
          "A home, or a shipped one: its devices become members, its containers controllers.")
  private Optional<String> home;

  @Option(
      names = "--site",
      paramLabel = "NAME",
      defaultValue = "maestro",
      description = "The platform's name; default ${DEFAULT-VALUE}.")
  private String site;

  @Option(
      names = "--host",
      split = ",",
      paramLabel = "HOST",
      description = "Names and addresses of the broker, beside this machine's own.")
  private List<String> hosts = List.of();

  @Option(names = "--member", split = ",", paramLabel = "ID", description = "Further members.")
  private List<String> members = List.of();

  @Option(
      names = "--controller",
      split = ",",
      paramLabel = "ID",
      description = "Further controllers.")
  private List<String> controllers = List.of();

  @Option(
      names = "--guest",
      split = ",",
      paramLabel = "ID",
      description = "Further users who may join the platform and ask there, such as a tablet's.")
  private List<String> guests = List.of();

  @Override
  public Integer call() {
    TreeSet<String> allMembers = new TreeSet<>(members);
    TreeSet<String> allControllers = new TreeSet<>(USUAL_CONTROLLERS);
    allControllers.addAll(controllers);
    home.map(Shipped::home)
        .ifPresent(
            loaded -> {
              allMembers.addAll(loaded.devices().keySet());
              loaded.devices().values().stream()
                  .flatMap(device -> device.container().stream())
                  .forEach(topic -> allControllers.add("container-" + topic));
            });
    List<String> allHosts = new ArrayList<>(hosts);
    allHosts.addAll(LOCAL_HOSTS);
    List<String> allGuests = new ArrayList<>(guests);
    allGuests.add(SecurityOptions.CONSOLE);
    SiteUsers users =
        SecureSite.make(directory, site, allHosts, allControllers, allMembers, allGuests);
    PrintWriter out = spec.commandLine().getOut();
    out.printf(
        "The site %s is secured by the files in %s: %d members, %d controllers, %d guests.%n",
        users.site(),
        directory,
        users.members().size(),
        users.controllers().size(),
        users.guests().size());
    out.printf(
        "Who may call what: %s. A device gets its folder below %s.%n",
        directory.resolve("rules.txt"), directory.resolve("users"));
    out.printf("Run it with: ./maestro run HOME --security %s%n", directory);
    return ExitCode.DONE;
  }
}
