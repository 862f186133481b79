package org.maestro.members;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.api.MemberWord;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.MemberStatus;

/** Whoever listens to a member learns when its life ends, also when nobody saw it go. */
class MemberNewsTest {
  private static final String ROSE = "rose";
  private static final Device DEVICE =
      new HomeLoader()
          .load(Path.of("../scenarios/assembly/src/main/resources/homes/bob.ttl"))
          .devices()
          .get(ROSE);

  private final List<String> heard = new ArrayList<>();
  private final MemberView view = new MemberView("listener", () -> {});
  private final MemberNews news =
      new MemberNews(
          ROSE,
          view,
          (description, speaker) -> {
            if (description.equals("faulty")) {
              throw new IllegalArgumentException("It is faulty.");
            }
            return DEVICE;
          },
          new MemberNews.Listener() {
            @Override
            public void described(String description) {
              heard.add("described " + description);
            }

            @Override
            public void refused(RuntimeException why) {
              heard.add("refused");
            }

            @Override
            public void said(MemberWord word) {
              heard.add("said " + word.facts());
            }

            @Override
            public void lost(String reason) {
              heard.add(reason);
            }
          });
  private long statesHeard;

  /** Its last will was overtaken by its new status: it was never seen to be away. */
  @Test
  void whoBeganAnewWithinAMomentWasLost() {
    news.changed(ready("first", "as ever"));
    heard.clear();

    news.changed(ready("second", "as ever"));

    assertThat(heard)
        .containsExactly("rose has begun anew", "described as ever", "said [(in Cup rose)]");
    assertThat(view.isReady()).isTrue();
    assertThat(news.boot()).isEqualTo("second");
  }

  @Test
  void whoLivesOnWasNot() {
    news.changed(ready("first", "as ever"));
    heard.clear();

    news.changed(ready("first", "with more"));

    assertThat(heard).containsExactly("described with more", "said [(in Cup rose)]");
  }

  @Test
  void whoWasSeenToGoIsLostOnce() {
    news.changed(ready("first", "as ever"));
    heard.clear();

    news.changed(
        new RatsLink.Member(
            ROSE,
            MemberStatus.Phase.LOST,
            "first",
            Optional.of("as ever"),
            Optional.empty(),
            statesHeard));
    news.changed(ready("second", "as ever"));

    assertThat(heard).containsExactly("rose is lost", "described as ever", "said [(in Cup rose)]");
  }

  @Test
  void whoseNewLifeCannotBeReadIsLostAndRefused() {
    news.changed(ready("first", "as ever"));
    heard.clear();

    news.changed(ready("second", "faulty"));

    assertThat(heard).startsWith("rose has begun anew", "refused");
    assertThat(view.isReady()).isFalse();
  }

  private RatsLink.Member ready(String boot, String description) {
    return new RatsLink.Member(
        ROSE,
        MemberStatus.Phase.READY,
        boot,
        Optional.of(description),
        Optional.of(
            new MemberState(
                ROSE, boot, "standby", List.of("(in Cup rose)"), List.of(), List.of(), List.of())),
        ++statesHeard);
  }
}
