// Where the page answers by itself, in place of the pose and its numbers: what an installation adds.
export function NoNumbers() {
  return (
    <section class="pose-panel no-numbers" aria-label="Numbers of the pose" data-testid="no-numbers">
      <p>
        The algebra is computed in this page. How close a pose is to a singularity, paths, maps, robots with dimensions and reports
        need an installation:
      </p>
      <p>
        <code>pip install "gcrules[studio]"</code>, then <code>gcrules studio</code>
      </p>
    </section>
  );
}
