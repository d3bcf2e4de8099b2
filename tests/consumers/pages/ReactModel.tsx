/** The part of the scene that the test of hot reload edits. */
export function ReactModel() {
  return (
    <mesh name="edited" position-x={0.9}>
      <boxGeometry args={[0.6, 0.6, 0.6]} />
      <meshStandardMaterial />
    </mesh>
  );
}
