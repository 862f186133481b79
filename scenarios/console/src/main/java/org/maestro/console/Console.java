package org.maestro.console;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.maestro.console.access.Access;
import org.maestro.console.access.Readership;
import org.maestro.console.api.AnswerOperations;
import org.maestro.console.api.Api;
import org.maestro.console.api.DayOperations;
import org.maestro.console.api.HistoryOperations;
import org.maestro.console.api.OpenApiDocument;
import org.maestro.console.api.Operation;
import org.maestro.console.api.PlanOperations;
import org.maestro.console.api.SessionOperations;
import org.maestro.console.history.Answerer;
import org.maestro.console.history.History;
import org.maestro.console.members.MemberOperations;
import org.maestro.console.questions.AclQuestions;
import org.maestro.console.questions.RefusalException;
import org.maestro.console.states.PlatformStates;
import org.maestro.console.truth.Truth;
import org.maestro.console.truth.TruthOperations;
import org.maestro.platform.MaestroPlatform;
import org.maestro.rats.transport.Transport;

/**
 * The console of a platform of this process (Three-layered architecture, 3; M25, M68): a page for
 * people, and the API that the page and all programs use. Any thread may close it.
 */
public final class Console implements AutoCloseable {
  private static final Duration MEASURED = Duration.ofSeconds(10);

  private final ConsoleServer server;
  private final Predicate<String> isFaceShown;
  private final List<Runnable> ends;

  /**
   * @param isFaceShown whether a page shows the face of that member
   * @param ends of its parts, in the order in which they are to end
   */
  private Console(ConsoleServer server, Predicate<String> isFaceShown, List<Runnable> ends) {
    this.server = server;
    this.isFaceShown = isFaceShown;
    this.ends = ends;
  }

  /**
   * Starts it.
   *
   * @param observer a client of the platform's bus that only listens; not open yet
   * @param name of the platform, and of its site on the bus
   * @param serving where, and to whom
   * @param data a directory in which the past is kept; empty: it ends with the process
   * @param truth of the home, where this process simulates it
   * @param version of the software
   * @throws RefusalException when the port is taken
   */
  public static Console start(
      MaestroPlatform platform,
      Transport observer,
      String name,
      Serving serving,
      Optional<Path> data,
      Optional<Truth> truth,
      String version) {
    requireFree(serving);
    Access access = serving.access();
    Readership readership = new Readership(platform.knowledge(), access.isSecured());
    AclQuestions questions = new AclQuestions(platform.desk());
    Health health = new Health(questions, platform::containers, platform::impediments);
    PlatformStates states = new PlatformStates(platform, EventHub.LOOK);
    History history =
        new History(
            data.map(directory -> directory.resolve("console")), platform::now, platform.speed());
    EventHub events =
        new EventHub(
            questions.of(readership.nameOfAll()),
            platform.knowledge(),
            readership,
            Map.of("health", health::document, "states", states::document),
            after -> history.answered(Answerer.AGENTS, after));
    Recording recording = new Recording(events, history, MEASURED);
    Traffic traffic =
        new Traffic(
            platform,
            name,
            observer,
            readership,
            after -> history.answered(Answerer.MEMBERS, after));
    Talk talk =
        new Talk(platform, questions.of(readership.nameOfAll()), readership, serving.paraphraser());
    Preview preview = new Preview(platform.knowledge(), platform::presentMembers);
    Queries queries = new Queries(platform.knowledge());
    OneByOne lookingBack =
        new OneByOne("console-past", "Others look back just now; ask again in a while.");
    List<Operation> operations =
        new ArrayList<>(
            new Api(
                    name,
                    platform.speed(),
                    truth.isPresent(),
                    questions,
                    platform.knowledge(),
                    readership,
                    preview::of,
                    queries::of)
                .operations());
    operations.addAll(new SessionOperations(access).operations());
    operations.addAll(PlanOperations.of(questions, readership, platform::now));
    operations.addAll(
        new AnswerOperations(platform::answers, platform.knowledge()::home, readership)
            .operations());
    operations.addAll(states.operations());
    operations.addAll(traffic.operations());
    operations.addAll(talk.operations());
    operations.addAll(TruthOperations.of(truth));
    operations.addAll(new MemberOperations(platform, traffic.roundTrips()).operations());
    operations.addAll(new HistoryOperations(history, lookingBack::work).operations());
    operations.add(
        new DayOperations(
                platform.diary(), platform.knowledge()::home, readership, lookingBack::work)
            .operation());
    ObjectNode document = OpenApiDocument.of(operations, version);
    Metrics metrics =
        new Metrics(
            questions, platform::containers, after -> history.answered(Answerer.API, after));
    ConsoleServer server =
        ConsoleServer.start(
            serving,
            new Entrance(access),
            operations,
            document.toString(),
            health,
            metrics,
            Map.of(
                "/events", events,
                "/events/bus", traffic.busNews(),
                "/events/chat", talk.news(),
                "/events/conversations", traffic.mailNews(),
                "/events/faces", traffic.faceNews(),
                "/events/streams", traffic.streamNews()));
    platform.onStory(events::told);
    platform.onStory(metrics::told);
    events.start();
    traffic.begin();
    talk.begin();
    recording.begin();
    return new Console(
        server,
        traffic.faceNews()::isShown,
        List.of(
            server::close,
            preview::close,
            queries::close,
            lookingBack::close,
            recording::close,
            events::close,
            traffic::close,
            talk::close,
            metrics::close));
  }

  private static void requireFree(Serving serving) {
    try (ServerSocket tried = new ServerSocket()) {
      tried.setReuseAddress(true);
      tried.bind(new InetSocketAddress(serving.host(), serving.port()));
    } catch (IOException e) {
      throw RefusalException.outside(
          "The console cannot listen on port %d of %s (%s); choose another one: --console PORT, or --console off."
              .formatted(serving.port(), serving.host(), e.getMessage()));
    }
  }

  /** Where the page is. */
  public URI uri() {
    return server.uri();
  }

  /**
   * Whether a page in somebody's browser shows the face of a member now. Any thread may ask.
   *
   * @param member its id
   */
  public boolean isFaceShown(String member) {
    return isFaceShown.test(member);
  }

  @Override
  public void close() {
    ends.forEach(Runnable::run);
  }
}
