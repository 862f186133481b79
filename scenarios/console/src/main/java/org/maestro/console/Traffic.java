package org.maestro.console;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.console.access.Readership;
import org.maestro.console.api.Operation;
import org.maestro.console.api.TrafficOperations;
import org.maestro.console.faces.FaceStates;
import org.maestro.console.trace.Traces;
import org.maestro.console.traffic.BusTraffic;
import org.maestro.console.traffic.CallMessages;
import org.maestro.console.traffic.MailTraffic;
import org.maestro.console.traffic.RoundTrips;
import org.maestro.console.traffic.StreamedFrames;
import org.maestro.platform.MaestroPlatform;
import org.maestro.platform.jade.SentMessage;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Transport;

/**
 * What goes over the bus and between agents, and what of it was for which goal, for who looks at
 * it.
 */
final class Traffic implements AutoCloseable {
  /** How the console asks, all the time, for the goals and agents that it shows. */
  private static final String HOW_THINGS_STAND = Words.print(Words.content("query-ref"));

  private final MaestroPlatform platform;
  private final BusTraffic bus;
  private final MailTraffic mail;
  private final CallMessages calls;
  private final Traces traces;
  private final RoundTrips roundTrips;
  private final ScheduledExecutorService thread =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread named = new Thread(task, "console-traffic");
            named.setDaemon(true);
            return named;
          });
  private final Broadcast busNews;
  private final Broadcast mailNews;
  private final FaceStates faces;
  private final Broadcast facesNews;
  private final FaceNews faceNews;
  private final StreamNews streamNews;
  private Runnable endOfMail = () -> {};
  private List<Future<?>> rounds = List.of();

  /**
   * @param name of the platform, and of its site on the bus
   * @param transport of a client that only listens; not open yet
   * @param readership who may read what is private
   * @param answered told how long members take to answer
   */
  Traffic(
      MaestroPlatform platform,
      String name,
      Transport transport,
      Readership readership,
      Consumer<Duration> answered) {
    this.platform = platform;
    this.faces = new FaceStates(name, platform.knowledge()::home, readership::ofAll);
    this.roundTrips = new RoundTrips(answered);
    this.calls = new CallMessages(name);
    this.traces = new Traces(name, platform::now);
    this.bus = new BusTraffic(transport, name, platform::now, this::heard);
    this.mail =
        new MailTraffic(
            name,
            message -> isOfConsole(message, name),
            platform::now,
            platform::containersElsewhere);
    this.busNews = new Broadcast("bus", bus, thread);
    this.mailNews = new Broadcast("conversations", mail, thread);
    this.facesNews = new Broadcast("faces", faces, thread);
    this.faceNews = new FaceNews(facesNews);
    this.streamNews = new StreamNews(new StreamedFrames(name, platform::instant));
  }

  /** The desk's question, and the search of the yellow pages that it makes the supervisor do. */
  private static boolean isOfConsole(SentMessage message, String platform) {
    return message.sender().equals("desk@" + platform) && message.content().equals(HOW_THINGS_STAND)
        || message.sender().equals(AgentNames.SUPERVISOR + "@" + platform)
            && message.receiver().equals("df@" + platform)
            && message.content().contains("(search ");
  }

  private void heard(Message message) {
    streamNews.heard(message);
    faces.heard(message);
    calls
        .read(message)
        .ifPresent(
            said -> {
              traces.heard(said);
              roundTrips.heard(said, System.nanoTime());
            });
  }

  /** How soon members have answered calls. */
  RoundTrips roundTrips() {
    return roundTrips;
  }

  List<Operation> operations() {
    return Stream.concat(
            TrafficOperations.of(bus, mail, traces).stream(), Stream.of(faces.operation()))
        .toList();
  }

  EventSource busNews() {
    return busNews;
  }

  EventSource mailNews() {
    return mailNews;
  }

  FaceNews faceNews() {
    return faceNews;
  }

  StreamNews streamNews() {
    return streamNews;
  }

  /** From now on it is listened to. */
  void begin() {
    platform.onStory(traces::told);
    Runnable endOfConversations = platform.onMail(mail::sent);
    Runnable endOfTraces = platform.onMail(traces::sent);
    endOfMail =
        () -> {
          endOfConversations.run();
          endOfTraces.run();
        };
    bus.listen();
    rounds = List.of(busNews.begin(), mailNews.begin(), facesNews.begin());
  }

  @Override
  public void close() {
    endOfMail.run();
    rounds.forEach(round -> round.cancel(false));
    thread.shutdownNow();
    bus.close();
  }
}
