package org.maestro.members;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class MemberViewTest {
  private static final List<String> HOLDS = List.of("(in Cup rose)");

  private final MemberView view = new MemberView();

  @Test
  void whatItSaysWhileACallRunsWaitsForTheReport() {
    view.ready(true);
    view.begun("c1", Map.of());

    assertThat(view.said(HOLDS)).isEmpty();
    assertThat(view.over()).isEqualTo(HOLDS);
  }

  /** It was lost with the cup in its hand: the end of its call must not tell that it holds it. */
  @Test
  void whatALostMemberSaidBeforeIsNoNews() {
    view.ready(true);
    view.begun("c1", Map.of());
    view.said(HOLDS);
    view.ready(false);

    assertThat(view.over()).isEmpty();
  }
}
