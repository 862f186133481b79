package org.maestro.platform;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;
import static org.awaitility.Awaitility.await;

import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import jade.wrapper.AgentContainer;
import jade.wrapper.ControllerException;
import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentSkipListSet;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.agents.GenericAgent;
import org.maestro.agents.SupervisorAgent;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.StartWords;
import org.maestro.agents.device.Host;
import org.maestro.agents.device.Surroundings;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Caller;
import org.maestro.agents.runtime.Spokesmen;
import org.maestro.agents.supervision.Containers;
import org.maestro.deployment.AgentStart;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.platform.guard.Guard;
import org.maestro.platform.jade.JadeRuntime;
import org.maestro.platform.jade.SharedParts;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.security.Role;
import org.maestro.rats.security.SecureSite;
import org.maestro.rats.security.SiteSecurity;
import org.maestro.rats.security.SiteUsers;
import org.maestro.rats.time.PacedClock;
import org.slf4j.LoggerFactory;

/**
 * Agents that JADE has made for somebody, and not for the supervisor: who registers which (ADE,
 * 3.1; A20).
 */
class RegistrationsTest {
  private static final AgentTime TIME = AgentTime.of(new PacedClock(1));

  /** To check a password takes long on purpose. */
  private static final Duration SOON = Duration.ofSeconds(60);

  @TempDir static Path directory;
  private static final ListAppender<ILoggingEvent> LOG = new ListAppender<>();
  private static final Set<String> TAKEN_IN = new ConcurrentSkipListSet<>();
  private static final Set<String> AT_WORK = new ConcurrentSkipListSet<>();
  private static Path site;
  private static BareJade jade;
  private static AgentContainer container;

  @BeforeAll
  static void start() throws Exception {
    LOG.start();
    ((Logger) LoggerFactory.getLogger(GenericAgent.class)).addAppender(LOG);
    site = directory.resolve("site");
    SecureSite.in(site)
        .make(
            new SiteUsers(
                "home",
                List.of("localhost"),
                new TreeSet<>(Set.of("maestro", "container-lights")),
                new TreeSet<>(),
                new TreeSet<>(),
                new TreeSet<>(Set.of("tablet")),
                new TreeMap<>(Map.of("ann", Role.ADMINISTRATOR, "vic", Role.VIEWER))));
    Guard guard = Guard.open(SiteSecurity.open(site), "maestro");
    jade = new BareJade("registering", directory, Optional.of(guard));
    RatsLink link =
        stub(
            RatsLink.class,
            (name, arguments) -> {
              if (name.equals("watch")) {
                AT_WORK.add(String.valueOf(arguments[0]));
              }
              return name.equals("watch") ? (Runnable) () -> {} : "nobody";
            });
    Registrations registrations = new Registrations(Optional.of(guard));
    Containers containers =
        stub(
            Containers.class,
            (name, arguments) -> {
              if (name.equals("startedByHand")) {
                AgentStart start = (AgentStart) arguments[0];
                registrations.require(start, (Caller) arguments[1], shown(arguments[2]));
                TAKEN_IN.add(start.agent());
              }
              return "";
            });
    Home home =
        new HomeLoader().load(Path.of("../scenarios/assembly/src/main/resources/homes/bob.ttl"));
    BareJade.start(
        jade.main(),
        AgentNames.SUPERVISOR,
        new SupervisorAgent(jade.birth(), TIME, link, containers, () -> home, Spokesmen.BY_NAME));
    container =
        JadeRuntime.join(
            Optional.of("registering"),
            "127.0.0.1",
            jade.port(),
            "lights",
            directory,
            new JadeRuntime.Entry(
                Optional.of(Guard.open(SiteSecurity.open(site), "container-lights")), false),
            new Host(new Surroundings(TIME, link, (text, member) -> home.devices().get(member))),
            SharedParts.fresh());
  }

  @AfterAll
  static void end() {
    jade.close();
    ((Logger) LoggerFactory.getLogger(GenericAgent.class)).detachAppender(LOG);
  }

  @SuppressWarnings("unchecked")
  private static Optional<StartWords.Shown> shown(Object argument) {
    return (Optional<StartWords.Shown>) argument;
  }

  /** What is asked of one that does next to nothing. */
  private interface Deed {
    Object done(String method, Object[] arguments);
  }

  private static <T> T stub(Class<T> type, Deed deed) {
    return type.cast(
        Proxy.newProxyInstance(
            type.getClassLoader(),
            new Class<?>[] {type},
            (proxy, method, arguments) -> {
              Object answer = deed.done(method.getName(), arguments);
              return method.getReturnType().isInstance(answer) ? answer : null;
            }));
  }

  private static void startByHand(String agent, String... arguments) throws Exception {
    container.createNewAgent(agent, GenericAgent.class.getName(), (Object[]) arguments).start();
  }

  private static Path password(String text) throws Exception {
    Path file = directory.resolve("password-" + text.length());
    if (!Files.exists(file)) {
      Files.createFile(
          file, PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rw-------")));
    }
    return Files.writeString(file, text + "\n");
  }

  private static Path passwordOf(String person) {
    return site.resolve("users/" + person + "/console-password");
  }

  private static void awaitRefusal(String agent, String reason) {
    await()
        .atMost(SOON)
        .until(
            () ->
                List.copyOf(LOG.list).stream()
                    .map(ILoggingEvent::getFormattedMessage)
                    .anyMatch(
                        text ->
                            text.contains("The agent " + agent + " ends, as it is not registered")
                                && text.contains(reason)));
    await().atMost(SOON).until(() -> isGone(agent));
    assertThat(TAKEN_IN).doesNotContain(agent);
    assertThat(AT_WORK).doesNotContain(agent);
  }

  private static boolean isGone(String agent) {
    try {
      container.getAgent(agent);
      return false;
    } catch (ControllerException none) {
      return true;
    }
  }

  @Test
  void aWrongPasswordIsRefusedAndTheAgentEndsBeforeItHasDoneAnything() throws Exception {
    startByHand("lamp-a1", "-", "ann", password("guessed-by-somebody").toString());
    awaitRefusal("lamp-a1", "the password is not that of a person of this site");
  }

  @Test
  void whoShowsNoNameAndPasswordIsRefused() throws Exception {
    startByHand("lamp-a2");
    awaitRefusal("lamp-a2", "shows no user name and password");
  }

  @Test
  void whoMayOnlyLookStartsNoAgents() throws Exception {
    startByHand("lamp-a3", "-", "vic", passwordOf("vic").toString());
    awaitRefusal("lamp-a3", "vic may start no agent by hand");
  }

  @Test
  void anAdministratorsAgentIsTakenInAndBegins() throws Exception {
    startByHand("lamp-b1", "-", "ann", passwordOf("ann").toString());
    await().atMost(SOON).until(() -> TAKEN_IN.contains("lamp-b1") && AT_WORK.contains("lamp-b1"));
    assertThat(isGone("lamp-b1")).isFalse();
  }

  @Test
  void aGuestHasNoAgentsOfMembersWhateverHeShows() {
    Registrations registrations =
        new Registrations(Optional.of(Guard.open(SiteSecurity.open(site), "maestro")));
    assertThat(
            catchThrowable(
                () -> registrations.requireHost(new Caller("rose", Optional.of("tablet")))))
        .hasMessageContaining("rose@tablet is of a guest");
    registrations.requireHost(new Caller("rose", Optional.of("container-lights")));
  }
}
