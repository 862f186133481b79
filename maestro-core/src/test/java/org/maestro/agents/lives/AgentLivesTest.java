package org.maestro.agents.lives;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class AgentLivesTest {
  private final AgentLives lives = new AgentLives();
  private final List<String> heard = new ArrayList<>();

  @Test
  void everyListenerHearsInTheOrderInWhichItCame() {
    lives.listen(hearing("first"));
    lives.listen(hearing("second"));

    lives.tell(listener -> listener.agentBegins("lamp"));
    lives.tell(listener -> listener.agentEnded("lamp"));

    assertThat(heard)
        .containsExactly(
            "first: lamp begins", "second: lamp begins", "first: lamp ended", "second: lamp ended");
  }

  @Test
  void whatADeathMeansIsToldWhileTheDeathIsTold() {
    lives.listen(
        new AgentLifeListener() {
          @Override
          public void agentDied(String agent) {
            lives.tell(listener -> listener.agentEnded(agent));
          }
        });
    lives.listen(hearing("desk"));

    lives.tell(listener -> listener.agentDied("lamp"));

    assertThat(heard).containsExactly("desk: lamp ended");
  }

  @Test
  void whatEndsWithThePlatformIsNotTold() {
    lives.listen(hearing("desk"));

    lives.end();
    lives.tell(listener -> listener.agentEnded("lamp"));

    assertThat(lives.areOver()).isTrue();
    assertThat(heard).isEmpty();
  }

  private AgentLifeListener hearing(String who) {
    return new AgentLifeListener() {
      @Override
      public void agentBegins(String agent) {
        heard.add(who + ": " + agent + " begins");
      }

      @Override
      public void agentEnded(String agent) {
        heard.add(who + ": " + agent + " ended");
      }
    };
  }
}
