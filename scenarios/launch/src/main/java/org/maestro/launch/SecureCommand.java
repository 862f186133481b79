package org.maestro.launch;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.maestro.assembly.LocalSite;
import org.maestro.rats.security.Role;
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
      names = "--viewer",
      split = ",",
      paramLabel = "NAME",
      description = "Persons who may look and ask at the console.")
  private List<String> viewers = List.of();

  @Option(
      names = "--operator",
      split = ",",
      paramLabel = "NAME",
      description = "Persons who may state and cancel goals and call devices there, too.")
  private List<String> operators = List.of();

  @Option(
      names = "--administrator",
      split = ",",
      paramLabel = "NAME",
      description =
          "Persons who may add, move and remove agents there, too; of a site without persons, one"
              + " called console is made.")
  private List<String> administrators = List.of();

  @Option(
      names = "--renew",
      split = ",",
      paramLabel = "ID",
      description =
          "Users who get new keys and certificates, with the broker; their former ones stay good."
              + " Persons get a new password, and the former one is good no more.")
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
          "New certificates and passwords: %s, and the broker. What runs here takes them up within seconds; a"
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
    TreeSet<String> allGuests = new TreeSet<>(guests);
    allGuests.add(SecurityOptions.CONSOLE);
    SiteUsers users =
        files.make(
            new SiteUsers(
                site,
                allHosts,
                allControllers,
                allMembers,
                new TreeSet<>(Set.of(LocalSite.OBSERVER)),
                allGuests,
                persons(files.hasPersons())));
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
    out.printf(
        "At the console may sign in: %s; the password of each is in %s.%n",
        users.persons().entrySet().stream()
            .map(person -> "%s (%s)".formatted(person.getKey(), person.getValue().word()))
            .collect(Collectors.joining(", ")),
        directory.resolve("users/NAME/console-password"));
    out.printf("Run it with: ./maestro run HOME --security %s%n", directory);
  }

  private SortedMap<String, Role> persons(boolean hasSome) {
    SortedMap<String, Role> persons = new TreeMap<>();
    viewers.forEach(name -> add(persons, name, Role.VIEWER));
    operators.forEach(name -> add(persons, name, Role.OPERATOR));
    administrators.forEach(name -> add(persons, name, Role.ADMINISTRATOR));
    if (persons.isEmpty() && !hasSome) {
      persons.put(SecurityOptions.CONSOLE, Role.ADMINISTRATOR);
    }
    return persons;
  }

  private static void add(SortedMap<String, Role> persons, String name, Role role) {
    Role other = persons.put(name, role);
    if (other != null) {
      throw CommandException.badInput(
          "%s cannot be both %s and %s; name one role.".formatted(name, other.word(), role.word()));
    }
  }
}
