package org.maestro.platform;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.maestro.agents.content.StartWords;
import org.maestro.agents.content.Words;
import org.maestro.deployment.AgentStart;
import org.maestro.deployment.ContainerStart;
import org.maestro.deployment.Deployment;
import org.maestro.deployment.Directory;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.MemberState;
import org.maestro.sl.Content;

/**
 * The contents of the platform's tables, put together (Three-layered architecture, 3.3.1, 3.3.2 and
 * 3.3.3; M65, M66, M70, M78): agents and containers as JADE has them, the members behind the agents
 * as the bus has them, and since when. Any thread may use it.
 */
final class PlatformTables {
  private final Deployment deployment;
  private final Directory directory;
  private final Supplier<Instant> now;
  private final Supplier<SortedMap<String, Arrivals.Refusal>> refused;
  private final Function<String, Optional<String>> driverOf;
  private final Map<String, Seen> seen = new ConcurrentHashMap<>();

  /** The state last heard of a member, and when its phase and z began to be these. */
  private record Seen(String phase, String state, List<String> disabled, Instant since) {}

  /**
   * @param refused members that cannot be used as they describe themselves
   * @param driverOf the kind of driver that runs a member's hardware, as it describes itself
   */
  PlatformTables(
      Deployment deployment,
      Directory directory,
      Supplier<Instant> now,
      Supplier<SortedMap<String, Arrivals.Refusal>> refused,
      Function<String, Optional<String>> driverOf) {
    this.deployment = deployment;
    this.directory = directory;
    this.now = now;
    this.refused = refused;
    this.driverOf = driverOf;
  }

  void memberChanged(RatsLink.Member member) {
    String phase = member.phase().name().toLowerCase(Locale.ROOT);
    String state = member.state().map(MemberState::state).orElse("-");
    List<String> disabled = member.state().map(MemberState::disabled).orElse(List.of());
    seen.compute(
        member.id(),
        (id, before) ->
            before != null && before.phase().equals(phase) && before.state().equals(state)
                ? new Seen(phase, state, disabled, before.since())
                : new Seen(phase, state, disabled, now.get()));
  }

  /** Whether JADE has an agent of that name. */
  boolean isThere(String agent) {
    return directory.find(agent).isPresent();
  }

  /**
   * Agents that stand for members, and groups.
   *
   * @param containers of these agents, by name
   */
  List<AgentRow> agents(Map<String, String> containers) {
    List<AgentRow> rows = new ArrayList<>();
    containers.forEach((agent, container) -> rows.add(row(agent, container)));
    return rows;
  }

  private AgentRow row(String agent, String container) {
    Optional<Directory.Entry> entry = directory.find(agent);
    Instant lives = entry.map(Directory.Entry::since).orElse(Instant.EPOCH);
    Optional<AgentStart> start = deployment.find(agent);
    List<String> members = start.map(AgentStart::members).orElse(List.of());
    if (start.isEmpty()) {
      return new AgentRow(agent, container, members, "group", "-", List.of(), lives);
    }
    List<Seen> known =
        members.stream()
            .map(m -> seen.getOrDefault(m, new Seen("absent", "-", List.of(), lives)))
            .toList();
    Instant since = known.stream().map(Seen::since).max(Comparator.naturalOrder()).orElse(lives);
    return new AgentRow(
        agent,
        entry.map(Directory.Entry::container).orElse(container),
        members,
        most(known.stream().map(Seen::phase).toList()),
        most(known.stream().map(Seen::state).toList()),
        disabled(members),
        since.isAfter(lives) ? since : lives);
  }

  private List<String> disabled(List<String> members) {
    return members.stream()
        .flatMap(
            member ->
                Optional.ofNullable(seen.get(member)).map(Seen::disabled).stream()
                    .flatMap(List::stream)
                    .map(feature -> members.size() == 1 ? feature : member + "/" + feature))
        .toList();
  }

  private static String most(Collection<String> words) {
    return words.stream()
        .collect(Collectors.groupingBy(word -> word, TreeMap::new, Collectors.counting()))
        .entrySet()
        .stream()
        .max(Map.Entry.comparingByValue())
        .map(Map.Entry::getKey)
        .orElse("-");
  }

  /**
   * The tables in words: a line for each agent that JADE has, for each member that has none of its
   * own and cannot be used since what it says of itself is faulty, and for each container.
   *
   * @param rows the agents that stand for members
   * @param services of each agent in the directory facilitator
   */
  List<Content> inWords(List<AgentRow> rows, Map<String, ? extends Set<String>> services) {
    Map<String, AgentRow> rowByAgent = new TreeMap<>();
    rows.forEach(row -> rowByAgent.put(row.agent(), row));
    SortedMap<String, Arrivals.Refusal> unused = new TreeMap<>(refused.get());
    List<Content> lines = new ArrayList<>();
    rows.forEach(row -> lines.add(line(row, services, ofAgent(row, unused))));
    directory.agents().stream()
        .filter(entry -> !rowByAgent.containsKey(entry.agent()))
        .map(
            entry ->
                new AgentRow(
                    entry.agent(),
                    entry.container(),
                    List.of(),
                    "-",
                    "-",
                    List.of(),
                    entry.since()))
        .forEach(row -> lines.add(line(row, services, Optional.empty())));
    unused.forEach((member, refusal) -> lines.add(line(member, refusal)));
    directory.containers().forEach(place -> lines.add(line(place)));
    return lines;
  }

  /** The refusal of the only member that the agent stands for is told in the agent's own line. */
  private static Optional<Arrivals.Refusal> ofAgent(
      AgentRow row, SortedMap<String, Arrivals.Refusal> unused) {
    return row.members().size() == 1
        ? Optional.ofNullable(unused.remove(row.members().get(0)))
        : Optional.empty();
  }

  private Content line(String member, Arrivals.Refusal refusal) {
    return Words.content(
        "inform",
        Words.named("members", List.of(Words.text(member))),
        Words.named("phase", Words.text("refused")),
        Words.named("since", Words.text(refusal.since().toString())),
        age(refusal.since()),
        Words.named("why", Words.text(refusal.why())));
  }

  private Content line(
      AgentRow row,
      Map<String, ? extends Set<String>> services,
      Optional<Arrivals.Refusal> refusal) {
    return Words.content(
        "inform",
        Words.named("agent", Words.text(row.agent())),
        Words.named("container", Words.text(row.container())),
        Words.named("members", row.members().stream().map(Words::text).toList()),
        Words.named(
            "drivers",
            row.members().stream().map(m -> Words.text(driverOf.apply(m).orElse(""))).toList()),
        Words.named("phase", Words.text(refusal.isPresent() ? "refused" : row.phase())),
        Words.named("state", Words.text(row.state())),
        Words.named("disabled", row.disabled().stream().map(Words::text).toList()),
        Words.named(
            "life",
            Words.text(directory.find(row.agent()).map(Directory.Entry::state).orElse("gone"))),
        Words.named("since", Words.text(row.since().toString())),
        age(row.since()),
        Words.named(
            "services",
            Optional.<Set<String>>ofNullable(services.get(row.agent()))
                .map(Set::copyOf)
                .orElse(Set.of())
                .stream()
                .sorted()
                .map(Words::text)
                .toList()),
        Words.named("why", refusal.map(Arrivals.Refusal::why).map(Words::text).stream().toList()));
  }

  private Content line(Directory.Place place) {
    Optional<ContainerStart> start = deployment.container(place.name());
    return Words.content(
        "inform",
        Words.named("place", Words.text(place.name())),
        Words.named("address", Words.text(place.address())),
        Words.named(
            "topics",
            start.map(ContainerStart::topics).orElse(Set.of()).stream().map(Words::text).toList()),
        Words.named(
            "provides",
            start.map(ContainerStart::provides).orElse(Set.of()).stream()
                .map(Words::text)
                .toList()),
        Words.named(
            "process",
            Words.text(
                start.map(c -> c.own() ? "own" : "joined").orElse(mainOrGuest(place.name())))),
        start
            .flatMap(ContainerStart::process)
            .map(StartWords::process)
            .orElse(new Content.Argument.Named("started", List.of())),
        Words.named(
            "holds",
            directory.agentsIn(place.name()).stream()
                .map(Directory.Entry::agent)
                .map(Words::text)
                .toList()),
        Words.named("since", Words.text(place.since().toString())),
        age(place.since()));
  }

  private Content.Argument age(Instant since) {
    return Words.named("age", Words.number(Duration.between(since, now.get()).toMillis() / 1000.0));
  }

  private static String mainOrGuest(String container) {
    return container.equals("Main-Container") ? "own" : "guest";
  }
}
