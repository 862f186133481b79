import java.net.URI;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import org.maestro.rats.member.Execution;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.Procedure;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.PahoTransport;

/** A bell that can be rung: a device of your own. Arguments: broker's host, port, and the site. */
public final class Bell {
  private static final String DESCRIPTION =
      """
      {"@context": ["https://w3id.org/maestro/context.jsonld", {"b": "https://example.org/bell#"}],
       "id": "b:bell-1", "label": "the bell", "type": "b:Bell",
       "offers": [
         {"id": "b:ring", "type": "maestro:Action", "label": "ring", "effect": "(rung ?self)",
          "cost": "1", "seconds": "1", "sentence": "{self} rings"}],
       "brings": [
         {"id": "b:Bell", "type": "owl:Class", "subClassOf": "maestro:Device"},
         {"id": "b:rung", "type": ["maestro:Predicate", "maestro:Observable"], "label": "rung",
          "arguments": ["?bell - Bell"]}]}
      """;

  public static void main(String[] arguments) throws InterruptedException {
    PacedClock clock = new PacedClock(1);
    AtomicBoolean rung = new AtomicBoolean();
    Procedure ring =
        new Procedure() {
          @Override
          public void start(Execution call) {
            // Here it rings. Nothing may block: the end comes later.
            clock.schedule(
                Duration.ofMillis(300),
                "bell-1",
                () -> {
                  rung.set(true);
                  call.succeed(Map.of());
                });
          }

          @Override
          public CostAnswer cost(Map<String, Object> parameters) {
            return new CostAnswer(Optional.of(1.0), Optional.of(1.0), Optional.empty());
          }
        };
    MemberProfile profile =
        new MemberProfile(
            "bell-1",
            DESCRIPTION,
            Set.of("standby"),
            "standby",
            Set.of("standby"),
            MemberProfile.byId(
                List.of(
                    new MemberProfile.Feature(
                        "ring", Set.of(), Set.of("clapper"), false, Optional.empty(), "standby", ring))));
    RatsMember.start(
        profile,
        () -> rung.get() ? List.of("(rung bell-1)") : List.of("(not (rung bell-1))"),
        new PahoTransport(
            URI.create("tcp://" + arguments[0] + ":" + arguments[1]), "bell-1"),
        arguments[2],
        clock);
    Thread.currentThread().join();
  }
}
