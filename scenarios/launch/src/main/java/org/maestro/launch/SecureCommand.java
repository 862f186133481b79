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
        "Make a secured site's certificates, users, rules and broker files; again: add users, give"
            + " them new certificates, or take them out. What runs by the files takes it up.")
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
      completionCandidates = Shipped.Homes.class,
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

  @Option(
      names = "--renew",
      split = ",",
      paramLabel = "ID",
      description =
          "Users who get new keys and certificates, with the broker; their former ones stay good.")
  private List<String> renewed = List.of();

  @Option(
      names = "--revoke",
      split = ",",
      paramLabel = "ID",
      description = "Users who are taken out of the site, and their certificates back.")
  private List<String> revoked = List.of();

  @Option(
      names = "--ca",
      paramLabel = "DIR",
      description =
          "Where the key of the site's authority is kept, which is not needed to run; without: in"
              + " ca below the site's directory.")
  private Optional<Path> authority = Optional.empty();

  @Override
  public Integer call() {
    SecureSite files =
        authority.map(key -> SecureSite.in(directory, key)).orElse(SecureSite.in(directory));
    if (renewed.isEmpty() && revoked.isEmpty()) {
      make(files);
      return ExitCode.DONE;
    }
    PrintWriter out = spec.commandLine().getOut();
    if (!revoked.isEmpty()) {
      files.revoke(revoked);
      out.printf(
          "Taken out of the site: %s. What runs here cuts them off within seconds; whoever has a"
              + " copy of the files needs the new ones, and mosquitto is to be started again.%n",
          String.join(", ", revoked));
    }
    if (!renewed.isEmpty()) {
      files.renew(renewed);
      out.printf(
          "New certificates: %s, and the broker. What runs here takes them up within seconds; a"
              + " device elsewhere needs its folder anew.%n",
          String.join(", ", renewed));
    }
    return ExitCode.DONE;
  }

  private void make(SecureSite files) {
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
    SiteUsers users = files.make(site, allHosts, allControllers, allMembers, allGuests);
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
    out.printf(
        "The key of its authority, %s, is not needed to run: keep it elsewhere, and name it with"
            + " --ca.%n",
        authority.orElse(directory.resolve("ca")).resolve("key.pem"));
    out.printf("Run it with: ./maestro run HOME --security %s%n", directory);
  }
}
